// Irradiance from finished maps at the points that the camera sees, on one thread where no number of threads
// is named. Items: points.
#include <benchmark/benchmark.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <optional>

#include "bench/micro/subjects.h"
#include "common/core/threads.h"

namespace bench {
namespace {

constexpr std::uint64_t default_hits = 1'000'000;
using shlm::default_texels;

template <common::IrradianceEstimator Map>
double sum_of_irradiance(const Map& map, std::span<const common::SurfacePoint> points) {
    double sum = 0;
    for (const common::SurfacePoint& point : points) {
        const common::Rgb irradiance = map.irradiance(point);
        sum += double{irradiance.x} + irradiance.y + irradiance.z;
    }
    return sum;
}

template <common::IrradianceEstimator Map>
double mean_irradiance(const Map& map, std::span<const common::SurfacePoint> points) {
    return sum_of_irradiance(map, points) / (3.0 * static_cast<double>(points.size()));
}

template <class Sink = photonmap::FlannPhotonSink>
auto photon_map(SharedInputs& inputs, std::uint64_t hits, const photonmap::PhotonSelection& selection = {}) {
    PreparedMethods& methods = inputs.methods(default_texels);
    return map_of(inputs.recording(hits),
                  Sink(methods.scene(), {selection, photonmap::Kernel::disc, methods.settings().max_radius},
                       &methods.covers()));
}

/// The same run `times` over: a billion hits in half a minute.
auto light_map(SharedInputs& inputs, std::size_t texels, std::uint64_t hits = default_hits, int times = 1,
               const shlm::Gather& gather = shlm::NearestTexels{}) {
    PreparedMethods& methods = inputs.methods(texels);
    shlm::Sink<shlm::PaperModel> sink(methods.texels(), gather, inputs.quantum());
    const Recording& recording = inputs.recording(hits);
    for (int i = 0; i < times; ++i) replay(recording, sink);
    return std::move(sink).finish(recording.report.watts_per_flux() / static_cast<float>(times));
}

/// A value that is made when first asked for: the maps take long to make, and most of them nobody asks for.
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

/// A map that is fast and wrong is not worth timing: its mean must be within 5 % of the `expected` one.
template <common::IrradianceEstimator Map>
void gather(benchmark::State& state, const Map& map, std::span<const common::SurfacePoint> points,
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

/// The same in parallel, in pieces of 64 points.
template <common::IrradianceEstimator Map>
void gather_in_parallel(benchmark::State& state, const Map& map, std::span<const common::SurfacePoint> points,
                        int threads) {
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
                                         gather_in_parallel(s, (*map)(), queries.image_order, threads);
                                     })
            ->UseRealTime();
}

/// `map` and `expected` are lazy.
template <class Map, class Expected>
void register_gather(SharedInputs& inputs, const std::string& name, Map map, Expected expected) {
    const QueryPoints& queries = inputs.queries();
    benchmark::RegisterBenchmark((name + "/order:image").c_str(),
                                 [&queries, map, expected](benchmark::State& s) {
                                     gather(s, (*map)(), queries.image_order, (*expected)());
                                 });
    benchmark::RegisterBenchmark((name + "/order:shuffled").c_str(),
                                 [&queries, map, expected](benchmark::State& s) {
                                     gather(s, (*map)(), queries.shuffled, (*expected)());
                                 });
}

}  // namespace

void register_gather_benchmarks(SharedInputs& inputs) {
    const auto of_photon_map =
        lazy([&] { return mean_irradiance(photon_map(inputs, default_hits), inputs.queries().image_order); });
    const auto of_light_map = lazy(
        [&] { return mean_irradiance(light_map(inputs, default_texels), inputs.queries().image_order); });
    // With fewer hits the photon map darkens edges by more than the 5 %.
    for (const std::uint64_t hits : {100'000ul, default_hits, 4 * default_hits}) {
        register_gather(inputs, fmt::format("gather/photonmap-flann/hits:{}", hits),
                        lazy([&inputs, hits] { return photon_map(inputs, hits); }), of_light_map);
        register_gather(inputs, fmt::format("gather/photonmap-compact/hits:{}", hits), lazy([&inputs, hits] {
                            return photon_map<photonmap::CompactPhotonSink>(inputs, hits);
                        }),
                        of_light_map);
    }
    for (const std::uint64_t hits : {default_hits, 4 * default_hits}) {
        using Nanoflann = photonmap::NanoflannPhotonSink;
        using Grid = photonmap::GridPhotonSink;
        constexpr photonmap::FixedRadius radius{0.003};
        register_gather(inputs, fmt::format("gather/photonmap-nanoflann/hits:{}", hits),
                        lazy([&inputs, hits] { return photon_map<Nanoflann>(inputs, hits); }), of_light_map);
        register_gather(inputs, fmt::format("gather/photonmap-grid-r0.003/hits:{}", hits),
                        lazy([&inputs, hits, radius] { return photon_map<Grid>(inputs, hits, radius); }),
                        of_light_map);
        register_gather(inputs, fmt::format("gather/photonmap-flann-r0.003/hits:{}", hits),
                        lazy([&inputs, hits, radius] { return photon_map(inputs, hits, radius); }),
                        of_light_map);
    }
    register_gather_in_parallel(
        inputs, fmt::format("gather/photonmap-compact/hits:{}", default_hits),
        lazy([&inputs] { return photon_map<photonmap::CompactPhotonSink>(inputs, default_hits); }));
    register_gather_in_parallel(inputs, fmt::format("gather/shlm/texels:{}", default_texels),
                                lazy([&inputs] { return light_map(inputs, default_texels); }));
    for (const auto& [hits, times] : {std::pair(100'000ul, 1), std::pair(default_hits, 1000)})
        register_gather(inputs, fmt::format("gather/shlm/hits:{}", hits * static_cast<std::uint64_t>(times)),
                        lazy([&inputs, hits = hits, times = times] {
                            return light_map(inputs, default_texels, hits, times);
                        }),
                        of_photon_map);
    for (const std::size_t texels : {4'096ul, 65'536ul, default_texels, 1'048'576ul})
        register_gather(inputs, fmt::format("gather/shlm/texels:{}", texels),
                        lazy([&inputs, texels] { return light_map(inputs, texels); }), of_photon_map);
    for (const auto& [name, other] : {std::pair("knn4", shlm::Gather(shlm::NearestTexels{4, false})),
                                      std::pair("bilinear", shlm::Gather(shlm::Bilinear{}))})
        register_gather(inputs, fmt::format("gather/shlm-{}/texels:{}", name, default_texels),
                        lazy([&inputs, gather = other] {
                            return light_map(inputs, default_texels, default_hits, 1, gather);
                        }),
                        of_photon_map);
}

}  // namespace bench
