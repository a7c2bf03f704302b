// Builds what a gather needs from what tracing has stored.
#include <benchmark/benchmark.h>

#include "bench/contenders/photon_map.h"
#include "bench/experiments/micro/subjects.h"
#include "common/core/threads.h"
#include "common/point_index/flann_index.h"

namespace bench::micro {
namespace {

/// Sorts recorded photons and builds the index over them. Items: hits.
void build_photon_map(benchmark::State& state, SharedInputs& inputs, const std::string& contender,
                      std::uint64_t hits, int threads) {
    common::ThreadPool pool(threads);
    const Contender named = parse_contender("micro", contender);
    for (auto _ : state) {
        state.PauseTiming();
        const std::unique_ptr<Store> store = inputs.store(contender);
        replay(inputs.recording(hits), *store);
        state.ResumeTiming();
        pool.run([&] {
            const FinishedMap map = named->finish(*store, inputs.recording(hits).report);
            benchmark::DoNotOptimize(map.answers->bytes());
        });
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(inputs.recording(hits).report.hits));
}

/// Builds FLANN's own index over photons in the order of tracing. This is the usual way to use it, without
/// the sorting that makes its build and its search faster. Items: hits.
void build_flann_unsorted(benchmark::State& state, SharedInputs& inputs, std::uint64_t hits) {
    std::vector<common::Vec3> positions;
    for (const auto& wave : inputs.recording(hits).waves)
        for (const common::HitBatch& batch : wave)
            for (std::size_t i = 0; i < batch.size(); ++i) positions.push_back(batch.position[i]);
    for (auto _ : state) {
        const common::FlannIndex index(positions);
        benchmark::DoNotOptimize(index.bytes());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
}

/// Builds the finished light map from its sums. Items: texels.
void build_light_map(benchmark::State& state, SharedInputs& inputs, std::size_t texels) {
    constexpr std::uint64_t hits = 100'000;
    const Contender named = parse_contender("micro", "shlm");
    const std::unique_ptr<Store> store = inputs.store("shlm", texels);
    replay(inputs.recording(hits), *store);
    for (auto _ : state) {
        const FinishedMap map = named->finish(*store, inputs.recording(hits).report);
        benchmark::DoNotOptimize(map.answers->bytes());
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(named->texel_count(inputs.prepared(texels))));
}

void register_photon_map(SharedInputs& inputs, const std::string& engine) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u, 10'000'000u})
        for (const int threads : {1, 2})
            benchmark::RegisterBenchmark(
                fmt::format("build/photonmap-{}/hits:{}/threads:{}", engine, hits, threads).c_str(),
                [&inputs, hits, threads, engine](benchmark::State& s) {
                    build_photon_map(s, inputs, fmt::format("photonmap/{}", engine), hits, threads);
                })
                ->UseRealTime();
}

}  // namespace

void register_build_benchmarks(SharedInputs& inputs) {
    for (const auto& [place, engine] : photon_map_engines())
        if (!engine.grows) register_photon_map(inputs, engine.name);
    for (const std::uint64_t hits : {1'000'000u, 10'000'000u})
        benchmark::RegisterBenchmark(
            fmt::format("build/flann-unsorted/hits:{}", hits).c_str(),
            [&inputs, hits](benchmark::State& s) { build_flann_unsorted(s, inputs, hits); });
    for (const std::size_t texels : {4'096u, 65'536u, 262'144u, 1'048'576u})
        benchmark::RegisterBenchmark(
            fmt::format("build/shlm/texels:{}", texels).c_str(),
            [&inputs, texels](benchmark::State& s) { build_light_map(s, inputs, texels); })
            ->UseRealTime();
}

}  // namespace bench::micro
