#include <gtest/gtest.h>

#include <random>

#include "photonmap/photon_sinks.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using photonmap::PackedLight;
using photonmap::SharedExponent;

double angle_between(const Vec3& a, const Vec3& b) {
    const Imath::V3d x(a), y(b);
    return std::atan2(x.cross(y).length(), x.dot(y));
}

TEST(PackedPhoton, KeepsFluxToTenBitsOfTheLargest) {
    constexpr unsigned seed = 3;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 100'000; ++i) {
        const float scale = std::exp2(200 * uniform(engine) - 100);
        const Rgb flux = Rgb(uniform(engine), uniform(engine), uniform(engine)) * scale;
        const Rgb back = SharedExponent::unpack(SharedExponent::pack(flux));
        for (int c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(back[c] - flux[c]), 0x1p-10f * common::max_component(flux)) << flux;
    }
}

TEST(PackedPhoton, KeepsWhatLiesAtTheEndsOfTheRange) {
    const auto round_trip = [](const Rgb& flux) {
        return SharedExponent::unpack(SharedExponent::pack(flux));
    };
    EXPECT_EQ(round_trip({0, 0, 0}), Rgb(0, 0, 0));
    EXPECT_EQ(round_trip({1, 0.5f, 0}), Rgb(1, 0.5f, 0));
    EXPECT_EQ(round_trip({1e-38f, 0, 0}), Rgb(0, 0, 0)) << "too little to tell from nothing";
    EXPECT_NEAR(round_trip({0x1.fffffep0f, 0, 0}).x, 2, 1e-6) << "rounds up to the next exponent";
    const Rgb largest = round_trip({std::numeric_limits<float>::infinity(), 3e38f, 1e30f});
    EXPECT_NEAR(largest.x / 3e38f, 1, 0x1p-10);
    EXPECT_NEAR(largest.y / 3e38f, 1, 0x1p-10);
}

TEST(PackedPhoton, PutsItsPartsTogether) {
    const Vec3 direction = Vec3(1, -2, 3).normalized();
    const PackedLight light = PackedLight::pack(direction, {3, 2, 1});
    EXPECT_EQ(light.facing_flux(), Rgb(3, 2, 1));
    EXPECT_LE(angle_between(light.direction(), direction), std::sqrt(4.5) / 4095 + 1e-6);
}

/// Makes a sphere and a box in a box, lit from inside: all kinds of normals, and light from all directions.
const Scene& lit_room() {
    static const Scene made = [] {
        Scene scene = closed_box(diffuse(Rgb(0.7f, 0.5f, 0.3f)));
        add(scene, sphere({0.3f, 0.2f, -0.4f}, 0.4f, 3), double_sided(diffuse(Rgb(0.6f, 0.6f, 0.6f))));
        add(scene, quad({-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}),
            diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
        return scene;
    }();
    return made;
}

struct Maps {
    photonmap::PhotonMap<common::FlannIndex> flann;
    photonmap::CompactPhotonSink::Map compact;
};

/// Makes both maps from the same photons.
Maps both_maps(const photonmap::GatherSettings& settings, std::uint64_t seed) {
    const auto traced = [&](auto sink) {
        const common::TraceReport report =
            trace(lit_room(), seed, {.hits = count_for(300'000, 60'000)}, sink);
        return common::finish_map(std::move(sink), report);
    };
    return {traced(photonmap::FlannPhotonSink(lit_room(), settings)),
            traced(photonmap::CompactPhotonSink(lit_room(), settings))};
}

/// Returns points on all surfaces, with shading normals up to 30 degrees off.
std::vector<common::SurfacePoint> query_points(std::size_t count, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<common::SurfacePoint> points;
    while (points.size() < count) {
        const auto triangle = static_cast<std::uint32_t>(engine() % lit_room().triangle.size());
        const float root = std::sqrt(uniform(engine)), v = uniform(engine) * root;
        points.push_back(tilted(front_of(lit_room(), {triangle, 1 - root, v}), uniform(engine) * 0.5,
                                2 * std::numbers::pi * uniform(engine)));
    }
    return points;
}

TEST(CompactPhotonMap, AgreesWithTheUnpackedOne) {
    const photonmap::PhotonSelection selections[] = {
        photonmap::NearestPhotons{50}, photonmap::GrowingNumber{0.02}, photonmap::FixedRadius{0.02}};
    for (const auto& selection : selections)
        for (const auto kernel : {photonmap::Kernel::disc, photonmap::Kernel::epanechnikov}) {
            const Maps maps = both_maps({selection, kernel, 0.2f}, 4);
            ASSERT_EQ(maps.flann.size(), maps.compact.size());
            ASSERT_EQ(maps.flann.nearest(), maps.compact.nearest());
            double squares = 0, sum = 0;
            const auto points = query_points(2000, 5);
            for (const common::SurfacePoint& point : points) {
                const double flann = common::mean_component(maps.flann.irradiance(point));
                const double compact = common::mean_component(maps.compact.irradiance(point));
                const double relative = flann > 0 ? compact / flann - 1 : compact;
                squares += relative * relative;
                sum += relative;
            }
            // A photon's flux is rounded by at most 2^-10 of its largest channel, which is at most three
            // times the mean. Its direction is rounded by 5.2e-4 radians, which changes its weight by that
            // times the tangent of its incidence. The tangent has a mean square of 12.8 in uniform light with
            // the cosine clamped at 0.001. In the worst case the errors of all photons of a gather add up.
            const double per_photon = 3 * 0x1p-10 + std::sqrt(12.8) * std::sqrt(4.5) / 4095;
            const auto count = static_cast<double>(points.size());
            EXPECT_LE(std::sqrt(squares / count), per_photon);
            EXPECT_LE(std::abs(sum / count), 0.1 * per_photon) << "packing is not biased";
        }
}

TEST(CompactPhotonMap, TakesAtMost24BytesAPhotonInAll) {
    const Maps maps = both_maps({.max_radius = 0.2f}, 6);
    EXPECT_LE(static_cast<double>(maps.compact.bytes()), 24.0 * static_cast<double>(maps.compact.size()));
    EXPECT_GT(static_cast<double>(maps.compact.bytes()), 22.0 * static_cast<double>(maps.compact.size()));
}

TEST(CompactPhotonMap, HoldsFewerPhotonsThanItIsAskedFor) {
    for (const std::size_t photons : {0, 1, 49, 50}) {
        common::HitBatch hits;
        for (std::size_t i = 0; i < photons; ++i)
            hits.push_back({0, 0, -1}, {0, 0, -1}, Rgb(1, 1, 1), on_quad(8, 0.5f, 0.5f));
        photonmap::CompactPhotonSink sink(lit_room(), {photonmap::NearestPhotons{50}, {}, 0.5f});
        sink.consume(std::span(&hits, 1));
        const auto map = std::move(sink).finish(1);
        ASSERT_EQ(map.size(), photons);
        const float irradiance = map.irradiance({{8, 0, 0}, {0, 0, -1}, {0, 0, 1}, {0, 0, 1}, true}).x;
        if (photons < 50) {
            EXPECT_NEAR(irradiance, static_cast<float>(photons) / (pi * 0.25), 1e-4) << photons;
        } else {
            EXPECT_GT(irradiance, 1e3f) << "all 50 in one point";
        }
    }
}

TEST(CompactPhotonMap, RejectsWhatIsNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    common::HitBatch hits;
    hits.push_back({0, 0, -1}, {0, 0, -1}, Rgb(1, 1, 1), on_quad(8, 0.5f, 0.5f));
    hits.push_back({nan, 0, -1}, {0, 0, -1}, Rgb(1, 1, 1), on_quad(8, 0.5f, 0.5f));
    hits.push_back({0, 0, -1}, {0, 0, -1}, Rgb(1, nan, 1), on_quad(8, 0.5f, 0.5f));
    photonmap::CompactPhotonSink sink(lit_room(), {.max_radius = 0.5f});
    sink.consume(std::span(&hits, 1));
    EXPECT_EQ(sink.rejected().not_finite, 2u);
    EXPECT_EQ(std::move(sink).finish(1).size(), 1u);
}

}  // namespace
