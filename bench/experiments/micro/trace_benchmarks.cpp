// Times tracing without a store, and into a light map. Items: hits.
#include <benchmark/benchmark.h>

#include "bench/experiments/micro/subjects.h"
#include "common/core/threads.h"

namespace bench::micro {
namespace {

/// Times `trace`, which returns the report of a run.
template <class Trace>
void measure(benchmark::State& state, const SharedInputs& inputs, std::uint64_t hits, int threads,
             const Trace& trace) {
    common::ThreadPool pool(threads);
    const TracedRun run{inputs.loaded().rays, inputs.source(), micro_seed, {.hits = hits}};
    std::uint64_t traced = 0;
    for (auto _ : state) pool.run([&] { traced += trace(run).hits; });
    state.SetItemsProcessed(static_cast<std::int64_t>(traced));
}

}  // namespace

void register_trace_benchmarks(SharedInputs& inputs) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u})
        for (const int threads : {1, 2}) {
            const std::string name = fmt::format("trace/null_sink/hits:{}/threads:{}", hits, threads);
            benchmark::RegisterBenchmark(name.c_str(), [&inputs, hits, threads](benchmark::State& s) {
                measure(s, inputs, hits, threads, trace_into_nothing);
            })->UseRealTime();
        }
    for (const int threads : {1, 2}) {
        const std::string name = fmt::format("trace/shlm/hits:{}/threads:{}", 4'000'000u, threads);
        benchmark::RegisterBenchmark(name.c_str(), [&inputs, threads](benchmark::State& s) {
            const std::unique_ptr<Store> store = inputs.store("shlm");
            measure(s, inputs, 4'000'000, threads,
                    [&](const TracedRun& run) { return trace_into(*store, run); });
        })->UseRealTime();
    }
}

}  // namespace bench::micro
