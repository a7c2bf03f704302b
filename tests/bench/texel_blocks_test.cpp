#include "shlm/map/texel_blocks.h"

#include <gtest/gtest.h>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/unit_floor.h"

namespace {

using namespace bench::scene_builder;
using namespace bench::stability;
using common::HitBatch;
using common::Scene;
using shlm::OwnTexel;

constexpr int side = 8;  // texels along each quad of these scenes, which are of 1 x 1

float middle_of(int texel) {
    return (static_cast<float>(texel) + 0.5f) / side;
}

/// Adds `count` hits of 1 W each, straight down, in the middle of a texel.
void add_hits(HitBatch& hits, const Scene& scene, std::uint32_t first_triangle, int column, int row,
              int count) {
    const SurfaceId on = on_quad(first_triangle, middle_of(column), middle_of(row));
    for (int i = 0; i < count; ++i)
        hits.push_back(common::position_at(scene, on), -scene.geometric_normal[first_triangle], {1, 1, 1},
                       on);
}

/// Returns the number of hits that a texel shows: the irradiance in its middle times its area.
template <class Map>
double shown(const Map& map, const Scene& scene, std::uint32_t first_triangle, int column, int row) {
    const SurfacePoint point = front_of(scene, on_quad(first_triangle, middle_of(column), middle_of(row)));
    return map.irradiance(point).x / (side * side);
}

/// Makes two quads that share one lightmap, half of it each.
Scene two_quads(const Mesh& left, const Mesh& right) {
    const auto half_from = [](float u) {
        return std::vector<Vec2>{{u, 0}, {u + 0.5f, 0}, {u + 0.5f, 1}, {u, 1}};
    };
    Scene scene;
    add(scene, joined(with_lightmap_uv(left, half_from(0)), with_lightmap_uv(right, half_from(0.5f))),
        diffuse({1, 1, 1}));
    return scene;
}

TEST(TexelBlocks, ASingleHitIsSharedByAll) {
    const Scene& scene = unit_floor();
    const auto texels = texels_of(scene, side * side);
    HitBatch hits;
    add_hits(hits, scene, 0, 3, 5, 1);
    const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 2);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            EXPECT_NEAR(shown(map, scene, 0, column, row), 1.0 / (side * side), 1e-6);
}

TEST(TexelBlocks, ABlockWithEnoughHitsIsDivided) {
    const Scene& scene = unit_floor();
    const auto texels = texels_of(scene, side * side);
    HitBatch hits;
    add_hits(hits, scene, 0, 0, 0, 10);  // in a block of 2 x 2 that has enough hits: each texel shows its own
    add_hits(hits, scene, 0, 7, 7, 6);   // in the opposite block, which has too few; its 4 x 4 has enough
    add_hits(hits, scene, 0, 4, 4, 4);
    const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 10);
    EXPECT_NEAR(shown(map, scene, 0, 0, 0), 10, 1e-5);
    EXPECT_EQ(shown(map, scene, 0, 1, 0), 0);
    EXPECT_EQ(shown(map, scene, 0, 2, 2), 0) << "no light comes from beyond the block";
    for (const int i : {6, 7}) EXPECT_NEAR(shown(map, scene, 0, i, i), 6.0 / 4, 1e-5);
    for (const int i : {4, 5}) EXPECT_NEAR(shown(map, scene, 0, i, i), 4.0 / 4, 1e-5);
}

TEST(TexelBlocks, WithoutLeastHitsEachTexelShowsItsOwn) {
    const Scene& scene = unit_floor();
    const auto texels = texels_of(scene, side * side);
    HitBatch hits;
    add_hits(hits, scene, 0, 3, 5, 1);
    const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 0);
    EXPECT_NEAR(shown(map, scene, 0, 3, 5), 1, 1e-6);
    EXPECT_EQ(shown(map, scene, 0, 2, 5), 0);
}

/// Sums the light of the whole surface, over a rectangle of texels whose sides are no powers of two, and
/// whose last row and column are cut.
TEST(TexelBlocks, NoLightIsLostOrMade) {
    const Mesh mesh = with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                       {{0, 0}, {0.93f, 0.04f}, {0.97f, 0.95f}, {0.06f, 0.91f}});
    Scene scene;
    add(scene, mesh, double_sided(diffuse({1, 1, 1})));
    const auto texels = texels_of(scene, 700);
    for (const std::size_t count : {1, 30, 300, 3000}) {
        Generator generator(count);
        HitBatch hits;
        irradiate_quad(hits, scene, 0, count, generator, always({0, 0, -1}));
        irradiate_quad(hits, scene, 0, count, generator, always({0, 0, 1}));
        const auto light_shown = [&](std::uint64_t least_hits) {
            const auto map = light_map_of<HarmonicModel<2>>(texels, hits, OwnTexel{}, least_hits);
            double light = 0;
            for (const auto& texel : map.texels()) light += texel.stored[0] * texel.face.area;
            return light;
        };
        EXPECT_GT(light_shown(0), 0);
        EXPECT_NEAR(light_shown(shlm::default_least_hits) / light_shown(0), 1, 1e-5) << count << " hits";
    }
}

TEST(TexelBlocks, FrontAndBackDoNotShare) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), double_sided(diffuse({1, 1, 1})));
    const auto texels = texels_of(scene, 2 * side * side);
    HitBatch hits;
    add_hits(hits, scene, 0, 3, 5, 1);
    const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 28);
    SurfacePoint back = front_of(scene, on_quad(0, 0.5f, 0.5f));
    back.front = false;
    EXPECT_GT(shown(map, scene, 0, 0, 0), 0);
    EXPECT_EQ(map.irradiance(back).x, 0);
}

TEST(TexelBlocks, DoNotReachAroundACorner) {
    const Scene scene =
        two_quads(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), quad({1, 0, 0}, {0, 0, 1}, {0, 1, 0}));
    const auto texels = texels_of(scene, 2 * side * side);
    HitBatch hits;
    add_hits(hits, scene, 0, 3, 5, 1);
    const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 28);
    EXPECT_NEAR(shown(map, scene, 0, 0, 0), 1.0 / (side * side), 1e-6);
    EXPECT_EQ(shown(map, scene, 2, 0, 0), 0);
}

TEST(TexelBlocks, DoNotReachOverToAChartFarAway) {
    const Mesh lit = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const float apart : {1.0f, 5.0f}) {
        const Scene scene = two_quads(lit, quad({apart, 0, 0}, {1, 0, 0}, {0, 1, 0}));
        const auto texels = texels_of(scene, 2 * side * side);
        HitBatch hits;
        add_hits(hits, scene, 0, 3, 5, 1);
        const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 28);
        const bool joined_up = apart == 1;
        EXPECT_NEAR(shown(map, scene, 2, 0, 0), joined_up ? 0.5 / (side * side) : 0, 1e-6) << apart;
    }
}

/// Light ends at x = 27.3 texels, where no block ends. Texels beyond share light only within a block that has
/// too few hits for itself: 8 x 8 at half a hit per texel, 2 x 2 at 4.
TEST(TexelBlocks, ShadowsStayDarkBesideEnoughLight) {
    const Scene& scene = unit_floor();
    const auto texels = texels_of(scene, 64 * 64);
    for (const auto& [hits_per_texel, dark_from] : {std::pair(0.5, 32), {4.0, 28}}) {
        HitBatch hits;
        Generator generator(1);
        for (int i = 0; i < hits_per_texel * 27.3 * 64; ++i) {
            const float x = 27.3f / 64 * uniform(generator), y = uniform(generator);
            hits.push_back({x, y, 0}, {0, 0, -1}, {1, 1, 1}, on_quad(0, x, y));
        }
        const auto map = light_map_of<FlatModel>(texels, hits, OwnTexel{}, 28);
        for (int row = 0; row < 64; ++row)
            for (int column = 0; column < 64; ++column) {
                const auto at = [](int texel) { return (static_cast<float>(texel) + 0.5f) / 64; };
                const float irradiance = map.irradiance(front_of(scene, on_quad(0, at(column), at(row)))).x;
                EXPECT_EQ(irradiance == 0, column >= dark_from) << hits_per_texel << ", column " << column;
            }
    }
}

}  // namespace
