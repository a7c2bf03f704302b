// Times adds to texels' sums in each candidate number format. Items: adds.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "bench/contenders/plain_sums.h"
#include "bench/experiments/micro/subjects.h"
#include "common/core/sampling.h"
#include "shlm/map/sink.h"

namespace bench::micro {
namespace {

using Model = shlm::PaperModel;

struct Add {
    std::uint32_t texel;
    common::Vec3 towards_light;
    float inverse_cosine;
    common::Rgb flux;
};

/// Returns uniform light on random texels.
const std::vector<Add>& random_adds(std::size_t texels) {
    static std::map<std::size_t, std::vector<Add>> made;
    std::vector<Add>& adds = made[texels];
    if (!adds.empty()) return adds;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::uniform_int_distribution<std::uint32_t> texel(0, static_cast<std::uint32_t>(texels) - 1);
    adds.resize(1 << 21);
    for (Add& add : adds) {
        const common::Vec3 light = common::sample_cosine_hemisphere(uniform(random), uniform(random));
        add = {texel(random), light, 1 / std::max(light.z, common::min_incident_cosine),
               common::Rgb(1, uniform(random), uniform(random))};
    }
    return adds;
}

template <class Sums>
void add_all(Sums& sums, std::span<const Add> adds) {
    constexpr std::size_t prefetch_distance = 16;
    for (std::size_t i = 0; i < adds.size(); ++i) {
        if (i + prefetch_distance < adds.size()) sums.prefetch(adds[i + prefetch_distance].texel);
        sums.add(adds[i].texel, adds[i].towards_light, adds[i].inverse_cosine, adds[i].flux);
    }
}

template <class Sums>
void sums(benchmark::State& state, std::size_t texels) {
    const std::vector<Add>& adds = random_adds(texels);
    Sums sums(texels, shlm::Quantum(common::Rgb(1, 1, 1)));
    add_all(sums, adds);  // touch the pages outside the timed loop
    for (auto _ : state) add_all(sums, adds);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(adds.size()));
    state.counters["bytes_per_texel"] = static_cast<double>(Sums::bytes_per_texel());
}

template <class Sums>
void register_format(const char* format) {
    for (const std::size_t texels : {4'096u, 262'144u, 4'194'304u})
        benchmark::RegisterBenchmark(fmt::format("sums/{}/texels:{}", format, texels).c_str(),
                                     [texels](benchmark::State& s) { sums<Sums>(s, texels); });
}

}  // namespace

void register_sums_benchmarks(SharedInputs&) {
    register_format<PlainSums<Model, float>>("float");
    register_format<FloatsDrainedIntoDoubles<Model>>("float-into-double");
    register_format<PlainSums<Model, double>>("double");
    register_format<PlainSums<Model, std::int64_t>>("int64");
    register_format<shlm::TexelSums<Model>>("int32-into-int64");
}

}  // namespace bench::micro
