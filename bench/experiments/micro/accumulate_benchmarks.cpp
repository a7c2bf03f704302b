// Adds recorded hits to the texels of a light map. Items: hits.
#include <benchmark/benchmark.h>

#include "bench/experiments/micro/subjects.h"
#include "common/core/threads.h"

namespace bench::micro {
namespace {

constexpr std::uint64_t hits = 1'000'000;

/// Adds to the same sums repeatedly: they do not grow, so each round costs the same.
void accumulate(benchmark::State& state, SharedInputs& inputs, std::size_t texels, int threads) {
    const Recording& recording = inputs.recording(hits);
    const std::unique_ptr<Store> store = inputs.store("shlm", texels);
    common::ThreadPool pool(threads);
    for (auto _ : state) pool.run([&] { replay(recording, *store); });
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recording.report.hits));
}

}  // namespace

void register_accumulate_benchmarks(SharedInputs& inputs) {
    for (const std::size_t texels : {4'096u, 65'536u, 262'144u, 1'048'576u})
        for (const int threads : {1, 2}) {
            const std::string name = fmt::format("accumulate/shlm/texels:{}/threads:{}", texels, threads);
            benchmark::RegisterBenchmark(name.c_str(), [&inputs, texels, threads](benchmark::State& s) {
                accumulate(s, inputs, texels, threads);
            })->UseRealTime();
        }
}

}  // namespace bench::micro
