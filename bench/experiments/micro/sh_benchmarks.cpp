// Times the harmonics alone: nine values of a direction, and irradiance from the coefficients of a texel.
#include <benchmark/benchmark.h>

#include "bench/experiments/micro/subjects.h"
#include "shlm/map/sink.h"

namespace bench::micro {
namespace {

constexpr std::uint64_t hits = 10'000;
constexpr std::size_t texels = 16'384;

/// Evaluates the directions of recorded hits. Items: directions.
void evaluate(benchmark::State& state, SharedInputs& inputs) {
    const common::HitBatch& batch = inputs.recording(hits).waves.back().back();
    for (auto _ : state)
        for (const common::Vec3& direction : batch.direction) {
            auto values = shlm::evaluate_sh<2>(direction);
            benchmark::DoNotOptimize(values);
        }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch.size()));
}

/// Evaluates each texel of a finished map at its own normal. Items: texels.
void irradiance(benchmark::State& state, SharedInputs& inputs) {
    shlm::Sink<shlm::PaperModel> sink(inputs.prepared(texels).texels(), shlm::NearestTexels{},
                                      shlm::Quantum(inputs.source().power()));
    for (const auto& wave : inputs.recording(hits).waves) sink.consume(wave);
    const auto map = common::finish_map(std::move(sink), inputs.recording(hits).report);
    for (auto _ : state)
        for (const auto& texel : map.texels()) {
            common::Rgb irradiance = texel.irradiance(texel.face.normal);
            benchmark::DoNotOptimize(irradiance);
        }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.texels().size()));
}

}  // namespace

void register_sh_benchmarks(SharedInputs& inputs) {
    benchmark::RegisterBenchmark("sh_evaluate", [&](benchmark::State& s) { evaluate(s, inputs); });
    benchmark::RegisterBenchmark("sh_irradiance", [&](benchmark::State& s) { irradiance(s, inputs); });
}

}  // namespace bench::micro
