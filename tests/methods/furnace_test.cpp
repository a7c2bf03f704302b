// A furnace test: the walls of a closed box all emit radiance 1 and reflect half. Radiance is 2 everywhere,
// and irradiance is 2 pi on every wall. A plane tilted by t sees the fraction (1 + cos t) / 2 of its
// hemisphere; the rest is behind the wall.
#include <gtest/gtest.h>

#include <random>

#include "photonmap/photon_sinks.h"
#include "shlm/map/sink.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;

constexpr std::uint64_t hit_count = count_for(10'000'000, 200'000);
constexpr std::size_t nearest_photons = count_for(200, 20);
constexpr int photon_map_queries = count_for(20'000, 2'000);
constexpr int light_map_queries = count_for(20'000, 5'000);
constexpr std::uint64_t seed = 1;
constexpr double tolerance = 0.01;
constexpr double tilts_in_degrees[] = {0, 15, 30, 45, 60};

const Scene& furnace() {
    static const Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
    return scene;
}

double irradiance_at_tilt(double tilt) {
    return 2 * pi * (1 + std::cos(tilt)) / 2;
}

using FluxModel = shlm::TexelModel<2, shlm::ShWeight::flux>;

struct Maps {
    photonmap::PhotonMap<common::FlannIndex> photons;
    shlm::HarmonicMap<shlm::PaperModel> radiance;
    shlm::HarmonicMap<FluxModel> flux;  ///< with the weight of the paper taken literally
};

/// Makes all maps from the same run.
Maps make_maps() {
    static const shlm::PreparedTexels texels(furnace(), shlm::find_lightmap_uv(furnace()), 2400);
    photonmap::FlannPhotonSink photons(
        furnace(), {.selection = photonmap::NearestPhotons{nearest_photons}, .max_radius = 0.2f});
    shlm::Sink<shlm::PaperModel> radiance(texels, shlm::NearestTexels{}, quantum_for(furnace()));
    shlm::Sink<FluxModel> flux(texels, shlm::NearestTexels{}, quantum_for(furnace()));
    Tee all(photons, radiance, flux);
    const common::TraceReport report = trace(furnace(), seed, {.hits = hit_count}, all);
    return {common::finish_map(std::move(photons), report), common::finish_map(std::move(radiance), report),
            common::finish_map(std::move(flux), report)};
}

const Maps& maps() {
    static const Maps made = make_maps();
    return made;
}

/// Returns the irradiance in the red channel at random points on the walls, at least `margin` from an edge,
/// tilted in random directions.
template <class Map>
Sample irradiance_of(const Map& map, double tilt, float margin, int queries) {
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::uniform_real_distribution<float> uniform(0, 1), inside(margin / 2, 1 - margin / 2);
    Sample sample;
    for (int i = 0; i < queries; ++i) {
        const auto wall = static_cast<std::uint32_t>(engine() % 6);
        const float s = inside(engine), t = inside(engine);
        sample.add(
            map.irradiance(tilted(front_of(furnace(), on_quad(2 * wall, s, t)), tilt, uniform(engine))).x);
    }
    return sample;
}

TEST(Furnace, PhotonMapIsRightAtEveryTilt) {
    for (const double degrees : tilts_in_degrees) {
        const double tilt = degrees * pi / 180, expected = irradiance_at_tilt(tilt);
        const Sample sample = irradiance_of(maps().photons, tilt, 0.2f, photon_map_queries);
        const double bound = std::max(tolerance * expected, z_for(1e-5) * sample.standard_error());
        EXPECT_NEAR(sample.mean(), expected, bound) << degrees << " degrees, seed " << seed;
    }
}

/// Bounds the mean over the light map. Weights 1 / cos, clamped at 1e-3, have a second moment of 14.8 and a
/// mean of 2. With the harmonics at a tilt and several hits per path, the variance per hit is below 10 times
/// the squared mean.
double light_map_bound(double expected) {
    return expected * std::max(tolerance, z_for(1e-5) * std::sqrt(10.0 / static_cast<double>(hit_count)));
}

TEST(Furnace, LightMapIsRightAtEveryTilt) {
    for (const double degrees : tilts_in_degrees) {
        const double tilt = degrees * pi / 180, expected = irradiance_at_tilt(tilt);
        const Sample sample = irradiance_of(maps().radiance, tilt, 0, light_map_queries);
        EXPECT_NEAR(sample.mean(), expected, light_map_bound(expected))
            << degrees << " degrees, seed " << seed;
    }
}

TEST(Furnace, LightMapWithoutTheCosineReadsTwoThirds) {
    // The expected value uses the integral of 2 x k2(x) over the hemisphere, k2 = (3 + 16 x + 15 x^2) / 32.
    const double expected = 2 * pi * 2 * (3.0 / 2 + 16.0 / 3 + 15.0 / 4) / 32;
    EXPECT_NEAR(expected / (2 * pi), 0.6615, 1e-4);
    const Sample sample = irradiance_of(maps().flux, 0, 0, light_map_queries);
    EXPECT_NEAR(sample.mean(), expected, light_map_bound(expected)) << "seed " << seed;
}

TEST(Furnace, EveryTexelIsRight) {
    // Tests each texel alone, within its own noise, also in the corners of the box.
    const double hits_per_texel = static_cast<double>(hit_count) / 2400;
    const double bound = z_for(1e-5 / 2400) * std::sqrt(10.0 / hits_per_texel);
    for (const auto& texel : maps().radiance.texels()) {
        const Rgb irradiance = texel.irradiance(texel.face.normal);
        ASSERT_NEAR(irradiance.x / (2 * pi), 1, bound) << "seed " << seed;
    }
}

}  // namespace
