// Recorded hits into an empty photon map. Items: hits.
#include <benchmark/benchmark.h>

#include "bench/micro/subjects.h"
#include "common/core/threads.h"

namespace bench {
namespace {

/// Begins with fresh memory each time, as a run does; giving it back is not timed.
template <class Sink>
void append(benchmark::State& state, SharedInputs& inputs, std::uint64_t hits, int threads) {
    const Recording& recording = inputs.recording(hits);
    common::ThreadPool pool(threads);
    for (auto _ : state) {
        std::optional<Sink> sink(std::in_place, inputs.loaded().scene, photonmap::GatherSettings{});
        pool.run([&] { replay(recording, *sink); });
        state.PauseTiming();
        sink.reset();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recording.report.hits));
}

template <class Sink>
void register_append(SharedInputs& inputs, const char* method, std::uint64_t hits, int threads) {
    const std::string name = fmt::format("append/{}/hits:{}/threads:{}", method, hits, threads);
    benchmark::RegisterBenchmark(name.c_str(), [&inputs, hits, threads](benchmark::State& s) {
        append<Sink>(s, inputs, hits, threads);
    })->UseRealTime();
}

}  // namespace

void register_append_benchmarks(SharedInputs& inputs) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        for (const int threads : {1, 2})
            register_append<photonmap::FlannPhotonSink>(inputs, "photonmap", hits, threads);
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        for (const int threads : {1, 2})
            register_append<photonmap::CompactPhotonSink>(inputs, "photonmap-compact", hits, threads);
    // FLANN inserts on one thread.
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        register_append<photonmap::FlannIncrementalPhotonSink>(inputs, "photonmap-flann-incremental", hits,
                                                               1);
}

}  // namespace bench
