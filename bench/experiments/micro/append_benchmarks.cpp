// Adds recorded hits to an empty photon map. Items: hits.
#include <benchmark/benchmark.h>

#include "bench/experiments/micro/subjects.h"
#include "common/core/threads.h"

namespace bench::micro {
namespace {

/// Begins with fresh memory each time, as a run does. Freeing it is not timed.
void append(benchmark::State& state, SharedInputs& inputs, const std::string& contender, std::uint64_t hits,
            int threads) {
    const Recording& recording = inputs.recording(hits);
    common::ThreadPool pool(threads);
    const Contender named = parse_contender("micro", contender);
    (void)named->prepare(inputs.prepared());
    for (auto _ : state) {
        std::unique_ptr<Store> store = named->make_store(inputs.prepared(), inputs.source());
        pool.run([&] { replay(recording, *store); });
        state.PauseTiming();
        store.reset();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recording.report.hits));
}

void register_append(SharedInputs& inputs, const char* name, const char* contender,
                     std::vector<int> threads) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        for (const int count : threads)
            benchmark::RegisterBenchmark(
                fmt::format("append/{}/hits:{}/threads:{}", name, hits, count).c_str(),
                [&inputs, contender, hits, count](benchmark::State& s) {
                    append(s, inputs, contender, hits, count);
                })
                ->UseRealTime();
}

}  // namespace

void register_append_benchmarks(SharedInputs& inputs) {
    register_append(inputs, "photonmap", "photonmap/flann", {1, 2});
    register_append(inputs, "photonmap-compact", "photonmap/compact", {1, 2});
    // FLANN inserts on one thread only.
    register_append(inputs, "photonmap-flann-incremental", "photonmap/flann-incremental", {1});
}

}  // namespace bench::micro
