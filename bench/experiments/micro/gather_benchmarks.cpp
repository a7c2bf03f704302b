// Evaluates finished maps at the points that the camera sees, on one thread unless the name says otherwise.
// Items: points.
#include <benchmark/benchmark.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <optional>

#include "bench/contenders/photon_map.h"
#include "bench/experiments/micro/subjects.h"
#include "common/core/threads.h"

namespace bench::micro {
namespace {

constexpr std::uint64_t default_hits = 1'000'000;
constexpr const char* radius = "r0.003";
using shlm::default_texels;

double sum_of_irradiance(const Answers& map, std::span<const common::SurfacePoint> points) {
    static thread_local std::vector<common::Rgb> answers;  // a gather must not allocate
    answers.resize(points.size());
    map.irradiance(points, answers);
    double sum = 0;
    for (const common::Rgb& irradiance : answers) sum += double{irradiance.x} + irradiance.y + irradiance.z;
    return sum;
}

double mean_irradiance(const Answers& map, std::span<const common::SurfacePoint> points) {
    return sum_of_irradiance(map, points) / (3.0 * static_cast<double>(points.size()));
}

/// A value that is made when first needed: maps take long to make, and most of them are not used.
template <class Make>
class Lazy {
  public:
    explicit Lazy(Make make) : make_(std::move(make)) {}
    const auto& operator()() {
        if (!value_) value_.emplace(make_());
        return *value_;
    }

  private:
    Make make_;
    std::optional<std::invoke_result_t<Make&>> value_;
};

template <class Make>
auto lazy(Make make) {
    return std::make_shared<Lazy<Make>>(std::move(make));
}

/// Times gathers. The mean must be within 5 % of the `expected` one, as a fast but wrong map is not worth
/// timing.
void gather(benchmark::State& state, const Answers& map, std::span<const common::SurfacePoint> points,
            double expected) {
    const double mean = mean_irradiance(map, points);
    if (!(std::abs(mean - expected) <= 0.05 * expected)) {
        state.SkipWithError(
            fmt::format("mean irradiance {:g} W/m^2, the other method has {:g}", mean, expected).c_str());
        return;
    }
    for (auto _ : state) {
        double sum = mean_irradiance(map, points);
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

/// Times the same in parallel, in pieces of 64 points.
void gather_in_parallel(benchmark::State& state, const Answers& map,
                        std::span<const common::SurfacePoint> points, int threads) {
    common::ThreadPool pool(threads);
    for (auto _ : state) {
        double sum = pool.run([&] {
            return tbb::parallel_reduce(
                tbb::blocked_range<std::size_t>(0, points.size(), 64), 0.0,
                [&](const tbb::blocked_range<std::size_t>& range, double so_far) {
                    return so_far + sum_of_irradiance(map, points.subspan(range.begin(), range.size()));
                },
                std::plus<>());
        });
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

template <class Map>
void register_gather_in_parallel(SharedInputs& inputs, const std::string& name, Map map) {
    const QueryPoints& queries = inputs.queries();
    for (const int threads : {1, 2})
        benchmark::RegisterBenchmark(fmt::format("{}/threads:{}", name, threads).c_str(),
                                     [&queries, map, threads](benchmark::State& s) {
                                         gather_in_parallel(s, *(*map)(), queries.image_order, threads);
                                     })
            ->UseRealTime();
}

/// Registers both orders; `map` and `expected` are lazy.
template <class Map, class Expected>
void register_gather(SharedInputs& inputs, const std::string& name, Map map, Expected expected) {
    const QueryPoints& queries = inputs.queries();
    benchmark::RegisterBenchmark((name + "/order:image").c_str(),
                                 [&queries, map, expected](benchmark::State& s) {
                                     gather(s, *(*map)(), queries.image_order, (*expected)());
                                 });
    benchmark::RegisterBenchmark((name + "/order:shuffled").c_str(),
                                 [&queries, map, expected](benchmark::State& s) {
                                     gather(s, *(*map)(), queries.shuffled, (*expected)());
                                 });
}

}  // namespace

void register_gather_benchmarks(SharedInputs& inputs) {
    const auto made = [&inputs](const std::string& contender, std::uint64_t hits, std::size_t texels,
                                int times) {
        return lazy([&inputs, contender, hits, texels, times] {
            return map_of(inputs, contender, texels, hits, times);
        });
    };
    const auto photon_map = [&](const std::string& contender, std::uint64_t hits) {
        return made(contender, hits, default_texels, 1);
    };
    const auto light_map = [&](std::size_t texels, std::uint64_t hits = default_hits, int times = 1) {
        return made("shlm", hits, texels, times);
    };
    const auto mean_of = [&inputs](auto map) {
        return lazy([&inputs, map] { return mean_irradiance(*(*map)(), inputs.queries().image_order); });
    };
    const auto of_photon_map = mean_of(photon_map("photonmap/flann", default_hits));
    const auto of_light_map = mean_of(light_map(default_texels));
    const auto register_photon_map = [&](const std::string& engine, const std::string& gather,
                                         std::uint64_t hits) {
        const bool said = !gather.empty();
        register_gather(
            inputs, fmt::format("gather/photonmap-{}{}{}/hits:{}", engine, said ? "-" : "", gather, hits),
            photon_map(fmt::format("photonmap/{}{}{}", engine, said ? "/" : "", gather), hits), of_light_map);
    };
    // With fewer hits the photon map darkens edges by more than 5 %.
    for (const char* engine : {"flann", "compact"}) register_photon_map(engine, "", 100'000);
    for (const std::uint64_t hits : {default_hits, 4 * default_hits}) {
        for (const auto& [place, engine] : photon_map_engines())
            if (!engine.grows) register_photon_map(engine.name, engine.for_one_radius ? radius : "", hits);
        register_photon_map("flann", radius, hits);
    }
    register_gather_in_parallel(inputs, fmt::format("gather/photonmap-compact/hits:{}", default_hits),
                                photon_map("photonmap/compact", default_hits));
    register_gather_in_parallel(inputs, fmt::format("gather/shlm/texels:{}", default_texels),
                                light_map(default_texels));
    // The same run is added repeatedly: a billion hits in half a minute.
    for (const auto& [hits, times] : {std::pair(100'000ul, 1), std::pair(default_hits, 1000)})
        register_gather(inputs, fmt::format("gather/shlm/hits:{}", hits * static_cast<std::uint64_t>(times)),
                        light_map(default_texels, hits, times), of_photon_map);
    for (const std::size_t texels : {4'096ul, 65'536ul, default_texels, 1'048'576ul})
        register_gather(inputs, fmt::format("gather/shlm/texels:{}", texels), light_map(texels),
                        of_photon_map);
    for (const char* other : {"knn4", "bilinear"})
        register_gather(inputs, fmt::format("gather/shlm-{}/texels:{}", other, default_texels),
                        made(fmt::format("shlm/L2/radiance/{}", other), default_hits, default_texels, 1),
                        of_photon_map);
}

}  // namespace bench::micro
