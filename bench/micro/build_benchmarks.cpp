// From what tracing has stored to what a gather needs.
#include <benchmark/benchmark.h>

#include <optional>

#include "bench/micro/subjects.h"
#include "common/core/threads.h"

namespace bench {
namespace {

/// Sorting recorded photons and FLANN's tree over them. Items: hits.
void build_flann(benchmark::State& state, SharedInputs& inputs, std::uint64_t hits) {
    for (auto _ : state) {
        state.PauseTiming();
        photonmap::PhotonStorage photons;
        for (const auto& wave : inputs.recording(hits).waves) photons.append(wave);
        state.ResumeTiming();
        const photonmap::PhotonStorage sorted = std::move(photons).sorted_along_curve();
        const common::FlannIndex index(sorted.positions());
        benchmark::DoNotOptimize(index.bytes());
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(inputs.recording(hits).report.hits));
}

/// Packed photons into the cells and leaves of the compact index. Items: hits.
void build_compact(benchmark::State& state, SharedInputs& inputs, std::uint64_t hits, int threads) {
    common::ThreadPool pool(threads);
    for (auto _ : state) {
        state.PauseTiming();
        std::optional<photonmap::PackedPhotonStorage> photons(std::in_place, inputs.loaded().scene);
        for (const auto& wave : inputs.recording(hits).waves) photons->append(wave);
        state.ResumeTiming();
        pool.run([&] { benchmark::DoNotOptimize((*std::move(photons)).indexed().index.bytes()); });
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(inputs.recording(hits).report.hits));
}

/// The finished light map from its sums. Items: texels.
void build_light_map(benchmark::State& state, SharedInputs& inputs, std::size_t texels) {
    constexpr std::uint64_t hits = 100'000;
    const Recording& recording = inputs.recording(hits);
    const shlm::PreparedTexels& prepared = inputs.methods(texels).texels();
    shlm::Accumulator<shlm::PaperModel> accumulator(prepared.layout);
    replay(recording, accumulator);
    for (auto _ : state) {
        const shlm::LightMap<shlm::PaperModel> map(accumulator.sums(), prepared,
                                                   recording.report.watts_per_flux(), shlm::NearestTexels{});
        benchmark::DoNotOptimize(map.bytes());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(prepared.layout.texel_count()));
}

}  // namespace

void register_build_benchmarks(SharedInputs& inputs) {
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u, 10'000'000u})
        benchmark::RegisterBenchmark(fmt::format("build/photonmap-flann/hits:{}", hits).c_str(),
                                     [&inputs, hits](benchmark::State& s) { build_flann(s, inputs, hits); })
            ->UseRealTime();
    for (const std::uint64_t hits : {10'000u, 100'000u, 1'000'000u, 10'000'000u})
        for (const int threads : {1, 2}) {
            const std::string name = fmt::format("build/photonmap-compact/hits:{}/threads:{}", hits, threads);
            benchmark::RegisterBenchmark(name.c_str(), [&inputs, hits, threads](benchmark::State& s) {
                build_compact(s, inputs, hits, threads);
            })->UseRealTime();
        }
    for (const std::size_t texels : {4'096u, 65'536u, 262'144u, 1'048'576u})
        benchmark::RegisterBenchmark(
            fmt::format("build/shlm/texels:{}", texels).c_str(),
            [&inputs, texels](benchmark::State& s) { build_light_map(s, inputs, texels); })
            ->UseRealTime();
}

}  // namespace bench
