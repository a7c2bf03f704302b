// Tests the division of a reference's light into direct and indirect.
#include "tests/support/reference_tracing.h"
#include "tests/support/see_through.h"

namespace {

using namespace tests;
using common::reference::LightPart;

constexpr std::uint64_t seed = 1;

/// Returns one sample of a part.
V3d sample(const common::RayScene& rays, const common::reference::Lights& lights, const SurfacePoint& point,
           std::uint32_t number, LightPart part) {
    using namespace common::reference;
    RandomStream stream(seed, 0, 0, number);
    const FirstNumbers first{{stream.next(), stream.next()}, {stream.next(), stream.next()}, stream.next()};
    return sample_irradiance(rays, lights, point, first, stream, max_surfaces, part);
}

Scene lit_box(const Material& walls) {
    Scene scene = closed_box(walls);
    add(scene, quad({-0.4f, -0.4f, 0.9f}, {0, 0.8f, 0}, {0.8f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
    add(scene, sphere({0.4f, 0.4f, -0.6f}, 0.3f, 2), glass());
    add(scene, quad({-0.9f, -0.9f, -0.8f}, {0.6f, 0, 0}, {0, 0.6f, 0.3f}), double_sided(mirror()));
    return scene;
}

TEST(LightParts, AddUpSampleForSample) {
    for (const Scene& scene : {lit_box(diffuse(Rgb(0.7f, 0.5f, 0.3f))), see_through_room()}) {
        const common::RayScene rays(scene);
        const common::reference::Lights lights(scene);
        std::mt19937 engine(static_cast<unsigned>(seed));
        V3d sums[2] = {V3d(0, 0, 0), V3d(0, 0, 0)};
        for (std::uint32_t i = 0; i < 2000; ++i) {
            const SurfacePoint point = random_point(scene, fronts(0, 12), engine);
            const V3d all = sample(rays, lights, point, i, LightPart::all),
                      direct = sample(rays, lights, point, i, LightPart::direct),
                      indirect = sample(rays, lights, point, i, LightPart::indirect);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(direct[c] + indirect[c], all[c], 1e-12 * (1 + all[c]));
            sums[0] += direct;
            sums[1] += indirect;
        }
        EXPECT_GT(sums[0].x, 0);
        EXPECT_GT(sums[1].x, 0);
    }
}

/// Nothing is indirect where nothing reflects or refracts.
TEST(LightParts, AreAllDirectBetweenBlackSurfaces) {
    Scene scene = closed_box(diffuse(Rgb(0, 0, 0)));
    add(scene, quad({-0.4f, -0.4f, 0.9f}, {0, 0.8f, 0}, {0.8f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
    const common::RayScene rays(scene);
    const common::reference::Lights lights(scene);
    std::mt19937 engine(static_cast<unsigned>(seed));
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const SurfacePoint point = random_point(scene, fronts(0, 12), engine);
        EXPECT_EQ(sample(rays, lights, point, i, LightPart::direct),
                  sample(rays, lights, point, i, LightPart::all));
        EXPECT_EQ(sample(rays, lights, point, i, LightPart::indirect), V3d(0, 0, 0));
    }
}

/// Light by mirror is indirect: the point sees the lamp in the mirror alone.
TEST(LightParts, CountMirroredLightAsIndirect) {
    Scene scene;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), diffuse(Rgb(0, 0, 0)));  // faces up
    add(scene, quad({-1, -1, 2}, {0, 2, 0}, {2, 0, 0}), mirror());               // faces down
    add(scene, quad({-0.3f, -0.3f, 1}, {0.6f, 0, 0}, {0, 0.6f, 0}), diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)));
    const common::RayScene rays(scene);
    const common::reference::Lights lights(scene);
    const SurfacePoint point = front_of(scene, on_quad(0, 0.9f, 0.5f));
    double indirect = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        EXPECT_EQ(sample(rays, lights, point, i, LightPart::direct), V3d(0, 0, 0));
        indirect += sample(rays, lights, point, i, LightPart::indirect).x;
    }
    EXPECT_GT(indirect, 0);
}

}  // namespace
