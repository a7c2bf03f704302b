// Tracing without a store, and into a light map. Items: hits.
#include <benchmark/benchmark.h>

#include "bench/micro/subjects.h"
#include "common/core/threads.h"
#include "common/tracer/null_sink.h"

namespace bench {
namespace {

template <common::PhotonSink Sink>
void trace(benchmark::State& state, const SharedInputs& inputs, std::uint64_t hits, int threads, Sink sink) {
    common::ThreadPool pool(threads);
    std::uint64_t traced = 0;
    for (auto _ : state)
        pool.run([&] {
            traced +=
                common::trace_photons(inputs.loaded().rays, inputs.source(), micro_seed, {.hits = hits}, sink)
                    .hits;
        });
    state.SetItemsProcessed(static_cast<std::int64_t>(traced));
}

}  // namespace

void register_trace_benchmarks(SharedInputs& inputs) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        for (const int threads : {1, 2}) {
            const std::string name = fmt::format("trace/null_sink/hits:{}/threads:{}", hits, threads);
            benchmark::RegisterBenchmark(name.c_str(), [&inputs, hits, threads](benchmark::State& s) {
                trace(s, inputs, hits, threads, common::NullSink());
            })->UseRealTime();
        }
    for (const int threads : {1, 2}) {
        const std::string name = fmt::format("trace/shlm/hits:{}/threads:{}", 4'000'000u, threads);
        benchmark::RegisterBenchmark(name.c_str(), [&inputs, threads](benchmark::State& s) {
            trace(s, inputs, 4'000'000, threads,
                  shlm::Accumulator<shlm::PaperModel>(inputs.methods(shlm::default_texels).texels().layout,
                                                      inputs.quantum()));
        })->UseRealTime();
    }
}

}  // namespace bench
