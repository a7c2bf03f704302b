// Tests which texels contribute at a point: the three gathers on maps whose texels hold chosen irradiances.
#include <gtest/gtest.h>

#include <random>

#include "shlm/map/light_map.h"
#include "tests/support/scene_builder.h"
#include "tests/support/texels.h"

namespace {

using namespace tests;
using shlm::Bilinear;
using shlm::Gather;
using shlm::NearestTexels;
using shlm::OwnTexel;
using shlm::PreparedTexels;
using shlm::TexelGeometry;

/// A model whose texels return what they hold, for every normal.
using Model = shlm::TexelModel<0, shlm::ShWeight::normalised>;
using LightMap = shlm::HarmonicMap<Model>;

const Material plain = diffuse(Rgb(0.5f, 0.5f, 0.5f));
const Gather all_gathers[] = {OwnTexel{}, Bilinear{}, NearestTexels{}, NearestTexels{1},
                              NearestTexels{4, false}};

/// Makes a map whose texel i holds `value(i)` in red, and twice and three times as much in green and blue.
/// Texels that nothing covers stay dark.
template <class SomeModel = Model, class Value>
shlm::HarmonicMap<SomeModel> map_with(const PreparedTexels& texels, const Gather& gather, Value value) {
    // The quantum is finer than usual, since gathers are compared to the last bits of a float.
    shlm::TexelSums<SomeModel> sums(texels.layout.texel_count(), shlm::Quantum(Rgb(1, 1, 1) * 0x1p-20f));
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i) {
        const TexelGeometry& texel = texels.geometry[i];
        const float watts = static_cast<float>(value(i)) * texel.area;
        if (texel.area > 0) sums.add(i, texel.normal, 1, Rgb(1, 2, 3) * watts);
    }
    return {sums, texels, 1, gather, 0};
}

/// Makes a map with the same value in every texel.
LightMap map_of_one(const PreparedTexels& texels, const Gather& gather, double value = 1) {
    return map_with(texels, gather, [&](std::uint32_t) { return value; });
}

/// Returns a different value for every texel, far from those of its neighbours.
double odd_value(std::uint32_t texel) {
    return 1 + (texel * 7919u) % 101;
}

/// Makes a floor from (0, 0) to (1, 1) at z = 0; u and v of its lightmap are x and y.
Scene floor_of(const Material& material) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
    return scene;
}

SurfacePoint back_of(const Scene& scene, const SurfaceId& surface) {
    return common::surface_point_at(scene, surface, scene.geometric_normal[surface.triangle]);
}

/// Calls `use(s, t)` for points all over the unit square: odd multiples of 1 / 256, none of them on a border
/// of texels with up to 64 texels per side.
template <class Use>
void for_points_of_square(Use use) {
    constexpr int side = 128;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            use((static_cast<float>(i) + 0.5f) / side, (static_cast<float>(j) + 0.5f) / side);
}

// Tests of all gathers.

TEST(TexelGather, BacksOfSingleSidedSurfacesAreDark) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    for (const Gather& gather : all_gathers) {
        const LightMap map = map_of_one(texels, gather);
        for_points_of_square([&](float s, float t) {
            ASSERT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(0, s, t))).x, 1) << gather.index();
            ASSERT_EQ(map.irradiance(back_of(scene, on_quad(0, s, t))), Rgb(0, 0, 0)) << gather.index();
        });
    }
}

TEST(TexelGather, FacesOfADoubleSidedSheetStayApart) {
    const Scene scene = floor_of(double_sided(plain));
    const PreparedTexels texels = texels_of(scene, 200);
    const std::uint32_t per_face = texels.layout.regions()[0].texels_per_face();
    ASSERT_EQ(texels.layout.texel_count(), 2 * per_face);
    for (const Gather& gather : all_gathers) {
        const LightMap map =
            map_with(texels, gather, [&](std::uint32_t texel) { return texel < per_face ? 1 : 5; });
        for_points_of_square([&](float s, float t) {
            ASSERT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(0, s, t))).x, 1) << gather.index();
            ASSERT_FLOAT_EQ(map.irradiance(back_of(scene, on_quad(0, s, t))).x, 5) << gather.index();
        });
    }
}

TEST(TexelGather, SurfacesWithoutTexelsAreDark) {
    Scene scene = floor_of(plain);
    Mesh unmapped = quad({0, 0, 5}, {1, 0, 0}, {0, 1, 0});
    for (auto& texcoord : unmapped.texcoord) texcoord.clear();
    add(scene, unmapped, double_sided(plain));
    add(scene, quad({0, 0, 10}, {1, 0, 0}, {0, 1, 0}), mirror());
    // Half of this mesh has lightmap coordinates that span no area.
    const Mesh half =
        joined(with_lightmap_uv(quad({0, 0, 15}, {1, 0, 0}, {0, 1, 0}), {{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
               with_lightmap_uv(quad({0, 0, 20}, {1, 0, 0}, {0, 1, 0}), {{0, 0}, {0, 0}, {0, 0}, {0, 0}}));
    add(scene, half, plain);
    const PreparedTexels texels = texels_of(scene, 128);
    for (const Gather& gather : all_gathers) {
        const LightMap map = map_of_one(texels, gather);
        for (const std::uint32_t dark : {2, 4, 8})
            EXPECT_EQ(map.irradiance(front_of(scene, on_quad(dark, 0.3f, 0.6f))), Rgb(0, 0, 0))
                << "triangle " << dark << ", gather " << gather.index();
        for (const std::uint32_t lit : {0, 6})
            EXPECT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(lit, 0.3f, 0.6f))).x, 1)
                << "triangle " << lit << ", gather " << gather.index();
    }
}

// Tests of the texel that contains the point.

TEST(OwnTexel, AnswersWithItsValue) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    ASSERT_EQ(texels.layout.regions()[0].width, 8u);
    ASSERT_EQ(texels.layout.regions()[0].height, 8u);
    const LightMap map = map_with(texels, OwnTexel{}, odd_value);
    for_points_of_square([&](float s, float t) {
        const auto texel = static_cast<std::uint32_t>(t * 8) * 8 + static_cast<std::uint32_t>(s * 8);
        const Rgb answer = map.irradiance(front_of(scene, on_quad(0, s, t)));
        for (int c = 0; c < 3; ++c)
            ASSERT_FLOAT_EQ(answer[c], static_cast<float>((c + 1) * odd_value(texel)));
    });
}

TEST(OwnTexel, HoldsTheTexelsOfTheLayoutAndTheirPlaces) {
    const Scene scene = closed_box(plain);
    const PreparedTexels texels = texels_of(scene, 500);
    for (const Gather& gather : {Gather(OwnTexel{}), Gather(Bilinear{})}) {
        const auto small = map_of_one(texels, gather);
        const auto large =
            map_with<shlm::TexelModel<4, shlm::ShWeight::normalised>>(texels, gather, odd_value);
        const std::size_t count = texels.layout.texel_count();
        const std::size_t places = shlm::TexelPlaces(texels.layout).bytes();
        ASSERT_EQ(small.texels().size(), count);
        EXPECT_EQ(small.bytes(), count * sizeof(small.texels()[0]) + places);
        EXPECT_EQ(large.bytes(), count * sizeof(large.texels()[0]) + places);
        EXPECT_EQ(sizeof(large.texels()[0]) - sizeof(small.texels()[0]), 17 * sizeof(Rgb));
        EXPECT_EQ(places, scene.triangle.size() * 16 + scene.instance.size() * sizeof(shlm::TexelRegion));
    }
}

// Tests of the four texels around the point in the lightmap.

double ramp(const Vec3& position) {
    return 3 + 2.0 * position.x - 1.0 * position.y;
}

/// Makes a map whose texels hold the ramp at their centres.
LightMap ramp_map(const PreparedTexels& texels) {
    return map_with(texels, Bilinear{}, [&](std::uint32_t i) { return ramp(texels.geometry[i].center); });
}

TEST(BilinearTexels, ReproduceARamp) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    const LightMap map = ramp_map(texels);
    for_points_of_square([&](float s, float t) {
        // Beyond the centres of the outer texels, values are constant.
        const auto inside = [](float x) { return std::clamp(x, 0.5f / 8, 7.5f / 8); };
        const double expected = ramp({inside(s), inside(t), 0});
        const Rgb answer = map.irradiance(front_of(scene, on_quad(0, s, t)));
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(answer[c], (c + 1) * expected, 1e-5) << s << ", " << t;
    });
}

/// Tests cut texels, whose areas differ by a factor of a hundred.
TEST(BilinearTexels, InHalvesAreWithinTheirRounding) {
    Scene scene;
    add(scene,
        with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                         {{0, 0}, {0.93f, 0.04f}, {0.97f, 0.95f}, {0.06f, 0.91f}}),
        plain);
    const PreparedTexels texels = texels_of(scene, 300);
    shlm::TexelSums<Model> sums(texels.layout.texel_count(), shlm::Quantum(Rgb(1, 1, 1) * 0x1p-20f));
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i)
        if (texels.geometry[i].area > 0)
            sums.add(i, texels.geometry[i].normal, 1,
                     Rgb(1, 1, 1) * (static_cast<float>(odd_value(i)) * texels.geometry[i].area));
    const LightMap floats(sums, texels, 1, Bilinear{}, 0);
    const shlm::LightMap<shlm::Harmonics<Model::order>, shlm::half> halves(sums, texels, 1, Bilinear{}, 0);
    for_points_of_square([&](float s, float t) {
        const SurfacePoint point = front_of(scene, on_quad(0, s, t));
        ASSERT_NEAR(halves.irradiance(point).x / floats.irradiance(point).x, 1, 0.01) << s << ", " << t;
    });
}

TEST(BilinearTexels, ReproduceARampOnAnyChart) {
    // Random charts are rotated, sheared and mirrored, so texels have all orientations on the surface.
    constexpr unsigned seed = 1;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int charts = 0; charts < 20;) {
        const Vec2 along_x(uniform(engine), uniform(engine)), along_y(uniform(engine), uniform(engine));
        const float area = along_x.x * along_y.y - along_x.y * along_y.x;
        if (std::abs(area) < 0.5f * along_x.length() * along_y.length()) continue;
        ++charts;
        Scene scene;
        add(scene,
            with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                             {{0, 0}, along_x, along_x + along_y, along_y}),
            plain);
        const PreparedTexels texels = texels_of(scene, 10'000);
        const LightMap map = ramp_map(texels);
        for_points_of_square([&](float s, float t) {
            if (std::min({s, t, 1 - s, 1 - t}) < 0.15f) return;  // several texels from the chart's border
            const SurfacePoint point = front_of(scene, on_quad(0, s, t));
            ASSERT_NEAR(map.irradiance(point).x, ramp(point.position), 2e-4) << "seed " << seed;
        });
    }
}

TEST(BilinearTexels, AreContinuous) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    const auto chequered = [](std::uint32_t texel) { return 1 + 9 * ((texel % 8 + texel / 8) % 2); };
    // The path crosses texels' borders, the quad's diagonal and half of the outermost texels.
    const Vec2 from(0.01f, 0.02f), to(0.99f, 0.71f);
    constexpr int steps = 20'000;
    const auto largest_step = [&](const LightMap& map) {
        double largest = 0, before = 0;
        for (int i = 0; i <= steps; ++i) {
            const Vec2 at = from + (to - from) * (static_cast<float>(i) / steps);
            const double now = map.irradiance(front_of(scene, on_quad(0, at.x, at.y))).x;
            if (i > 0) largest = std::max(largest, std::abs(now - before));
            before = now;
        }
        return largest;
    };
    // Values differ by 9 between neighbours, whose distance is a texel.
    const Vec2 step = (to - from) * (8.0f / steps);
    const double steepest = 9 * (step.x + step.y), rounding = 1e-4;
    EXPECT_LE(largest_step(map_with(texels, Bilinear{}, chequered)), steepest + rounding);
    EXPECT_GE(largest_step(map_with(texels, OwnTexel{}, chequered)), 8.9) << "the test would pass anything";
}

/// Counts the points whose bilinear filter would include a texel of `kind`: the cell of four centres around
/// the point holds one.
template <class Kind>
int points_beside(const PreparedTexels& texels, const Scene& scene, const std::vector<SurfaceId>& points,
                  Kind kind) {
    int count = 0;
    for (const SurfaceId& at : points) {
        const shlm::TriangleTexels& triangle = texels.layout.triangle(at.triangle);
        const Vec2 place = triangle.corner + triangle.edge_u * at.u + triangle.edge_v * at.v;
        const SurfacePoint point = front_of(scene, at);
        bool beside = false;
        for (const float dx : {-0.5f, 0.5f})
            for (const float dy : {-0.5f, 0.5f}) {
                const Vec2 corner(place.x + dx, place.y + dy);
                if (corner.x < 0 || corner.y < 0 || corner.x >= static_cast<float>(triangle.width) ||
                    corner.y >= static_cast<float>(triangle.height))
                    continue;
                const auto x = static_cast<std::uint32_t>(corner.x), y = static_cast<std::uint32_t>(corner.y);
                beside |= kind(texels.geometry[triangle.first_texel + y * triangle.width + x], point);
            }
        count += beside;
    }
    return count;
}

TEST(BilinearTexels, LeaveOutTexelsThatNothingCovers) {
    // A single triangle: half of its rectangle of texels is empty.
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangle.resize(1);
    Scene scene;
    add(scene, mesh, plain);
    const PreparedTexels texels = texels_of(scene, 200);
    std::vector<SurfaceId> points;
    for_points_of_square([&](float s, float t) {
        if (s > t) points.push_back(on_quad(0, s, t));
    });
    const int beside_empty = points_beside(
        texels, scene, points, [](const TexelGeometry& texel, const auto&) { return texel.area == 0; });
    ASSERT_GT(beside_empty, 100) << "the test would pass anything";
    const LightMap map = map_of_one(texels, Bilinear{}, 5);
    for (const SurfaceId& at : points) ASSERT_FLOAT_EQ(map.irradiance(front_of(scene, at)).x, 5);
}

/// Makes the walls of a box as one mesh, each with a sixth of the lightmap and no gap between them.
Mesh unwrapped_box() {
    const std::array<Mesh, 6> walls = box_walls({-1, -1, -1}, {1, 1, 1});
    Mesh box;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const float u = static_cast<float>(i % 3) / 3, v = i < 3 ? 0.0f : 0.5f, width = 1.0f / 3;
        const Mesh wall =
            with_lightmap_uv(walls[i], {{u, v}, {u + width, v}, {u + width, v + 0.5f}, {u, v + 0.5f}});
        box = i == 0 ? wall : joined(box, wall);
    }
    return box;
}

/// Returns which wall of the box has this normal: 1 to 6.
int wall_of(const Vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) > 0.99f) return 2 * axis + (normal[axis] < 0 ? 2 : 1);
    return 0;
}

TEST(BilinearTexels, LeaveOutTexelsThatLookAnotherWay) {
    Scene scene;
    add(scene, unwrapped_box(), plain);
    const PreparedTexels texels = texels_of(scene, 6 * 64);
    ASSERT_EQ(texels.layout.regions()[0].width, 24u);
    ASSERT_EQ(texels.layout.regions()[0].height, 16u);
    for (const TexelGeometry& texel : texels.geometry)
        ASSERT_GT(wall_of(texel.normal), 0) << "no shared texel";
    std::vector<SurfaceId> points;
    for (std::uint32_t wall = 0; wall < 6; ++wall)
        for_points_of_square([&](float s, float t) { points.push_back(on_quad(2 * wall, s, t)); });
    const int beside_others =
        points_beside(texels, scene, points, [](const TexelGeometry& texel, const SurfacePoint& point) {
            return wall_of(texel.normal) != wall_of(point.geometric_normal);
        });
    ASSERT_GT(beside_others, 1000) << "the test would pass anything";
    const LightMap map =
        map_with(texels, Bilinear{}, [&](std::uint32_t i) { return wall_of(texels.geometry[i].normal); });
    for (const SurfaceId& at : points) {
        const SurfacePoint point = front_of(scene, at);
        ASSERT_FLOAT_EQ(map.irradiance(point).x, static_cast<float>(wall_of(point.geometric_normal)));
    }
}

TEST(BilinearTexels, DoNotSeeOtherInstances) {
    // Two halves of a floor with the same lightmap coordinates, neighbours in space and in memory.
    Scene scene;
    for (const float x : {0.0f, 1.0f}) add(scene, quad({x, 0, 0}, {1, 0, 0}, {0, 1, 0}), plain);
    const PreparedTexels texels = texels_of(scene, 128);
    const std::uint32_t second = texels.layout.regions()[1].first_texel;
    const auto by_half = [&](std::uint32_t texel) { return texel < second ? 1 : 2; };
    for (const Gather& gather : {Gather(OwnTexel{}), Gather(Bilinear{})}) {
        const LightMap map = map_with(texels, gather, by_half);
        for_points_of_square([&](float s, float t) {
            ASSERT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(0, s, t))).x, 1);
            ASSERT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(2, s, t))).x, 2);
        });
    }
    // The nearest texels in space cross the seam.
    const LightMap nearest = map_with(texels, NearestTexels{}, by_half);
    EXPECT_NEAR(nearest.irradiance(front_of(scene, on_quad(0, 0.999f, 0.5f))).x, 1.5, 1e-5);
}

// Tests of the nearest texels in space.

TEST(NearestTexels, WeighByProjectedArea) {
    // A floor of one texel and a slope of 45 degrees beside it, also of one.
    Scene scene;
    add(scene, quad({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}), plain);
    add(scene, quad({0, 0, 0}, {1.25f, 0, 1.25f}, {0, 1, 0}), plain);
    const PreparedTexels texels = texels_of(scene, 2);
    ASSERT_EQ(texels.layout.texel_count(), 2u);
    ASSERT_NEAR(texels.geometry[1].area, 1.25 * std::sqrt(2.0), 1e-6);
    const auto value = [](std::uint32_t texel) { return texel == 0 ? 1 : 7; };
    const LightMap map = map_with(texels, NearestTexels{2}, value);
    // Seen from the floor, the slope has the area of its projection; seen from the slope, the floor is
    // smaller instead.
    const double shadow = 1.25, slope = 1.25 * std::sqrt(2.0), shrunk = std::sqrt(0.5);
    EXPECT_NEAR(map.irradiance(front_of(scene, on_quad(0, 0.7f, 0.4f))).x, (1 + 7 * shadow) / (1 + shadow),
                1e-5);
    EXPECT_NEAR(map.irradiance(front_of(scene, on_quad(2, 0.3f, 0.4f))).x,
                (shrunk + 7 * slope) / (shrunk + slope), 1e-5);
}

/// Computes the same answer from all texels, one after the other.
double nearest_by_search(const PreparedTexels& texels, const NearestTexels& gather,
                         const SurfacePoint& point) {
    float largest_area = 0;
    std::vector<std::pair<double, std::uint32_t>> candidates;
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i) {
        const TexelGeometry& texel = texels.geometry[i];
        largest_area = std::max(largest_area, texel.area);
        if (texel.area > 0 && texel.normal.dot(point.geometric_normal) > common::same_surface_cosine)
            candidates.emplace_back((texel.center - point.position).length(), i);
    }
    std::erase_if(candidates, [&](const auto& c) { return c.first > 4 * std::sqrt(largest_area); });
    std::sort(candidates.begin(), candidates.end());

    const auto nearest = [&](auto from) {
        from.resize(std::min(gather.count, from.size()));
        return from;
    };
    const auto of_other_surface = [&](const auto& candidate) {
        const std::uint32_t own = texels.pieces->of_triangle(point.surface.triangle);
        return !texels.pieces->meet(texels.geometry[candidate.second].piece, own);
    };
    auto chosen = nearest(candidates);
    if (gather.of_own_surface) {
        std::erase_if(chosen, of_other_surface);
        auto of_own = candidates;
        std::erase_if(of_own, of_other_surface);
        if (chosen.empty()) chosen = nearest(of_own.empty() ? candidates : of_own);
    }
    double sum = 0, weights = 0;
    for (const auto& [distance, index] : chosen) {
        const TexelGeometry& texel = texels.geometry[index];
        const double weight = double{texel.area} * texel.normal.dot(point.geometric_normal);
        sum += weight * odd_value(index);
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
}

TEST(NearestTexels, AreTheNearestThatLookThePointsWay) {
    // Texels of all sizes and slopes: a dome with coordinates projected from above, a floor, and a sheet
    // close above it.
    Scene scene;
    Mesh dome = sphere({0, 0, 0.5f}, 0.8f, 2);
    for (const Vec3& normal : dome.normal) dome.texcoord[1].emplace_back(normal.x, normal.y);
    std::erase_if(dome.triangle, [&](const common::TriangleVertices& corner) {
        return std::any_of(corner.begin(), corner.end(), [&](auto i) { return dome.normal[i].z < 0; });
    });
    add(scene, dome, plain);
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), plain);
    add(scene, quad({-1, -1, 0.05f}, {2, 0, 0}, {0, 2, 0}), double_sided(plain));
    const PreparedTexels texels = texels_of(scene, 900);
    constexpr unsigned seed = 2;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const NearestTexels& gather :
         {NearestTexels{1, false}, NearestTexels{4, false}, NearestTexels{8, false}, NearestTexels{1},
          NearestTexels{4}, NearestTexels{8}}) {
        const LightMap map = map_with(texels, gather, odd_value);
        for (int i = 0; i < 1000; ++i) {
            const float r1 = uniform(engine), r2 = uniform(engine);
            const Vec2 uv = common::sample_triangle(r1, r2);
            const SurfaceId at{static_cast<std::uint32_t>(engine() % scene.triangle.size()), uv.x, uv.y};
            const SurfacePoint point = i % 2 ? front_of(scene, at) : back_of(scene, at);
            const double expected = nearest_by_search(texels, gather, point);
            ASSERT_NEAR(map.irradiance(point).x, expected, 1e-4 * expected)
                << gather.count << " nearest" << (gather.of_own_surface ? " of the own surface" : "")
                << ", seed " << seed;
        }
    }
}

/// A lit floor at z = 0 above a dark one at this distance; texels of both are a tenth wide.
struct Layers {
    Scene scene;
    PreparedTexels texels;
    std::uint32_t first_below;

    explicit Layers(float depth)
        : scene(both(depth)),
          texels(texels_of(scene, 200)),
          first_below(texels.layout.regions()[1].first_texel) {}

    static Scene both(float depth) {
        Scene scene = floor_of(plain);
        add(scene, quad({0, 0, -depth}, {1, 0, 0}, {0, 1, 0}), plain);
        return scene;
    }

    [[nodiscard]] float least_above(const NearestTexels& gather) const {
        const LightMap map =
            map_with(texels, gather, [&](std::uint32_t texel) { return texel < first_below ? 1 : 0; });
        float least = 1;
        for_points_of_square([&](float s, float t) {
            least = std::min(least, map.irradiance(front_of(scene, on_quad(0, s, t))).x);
        });
        return least;
    }
};

TEST(NearestTexels, OfTheOwnSurfaceKnowNoLayerBehind) {
    for (const float depth : {1e-5f, 1e-3f, 0.01f, 0.05f}) {
        const Layers layers(depth);
        EXPECT_EQ(layers.least_above(NearestTexels{4}), 1) << depth;
        EXPECT_EQ(layers.least_above(NearestTexels{12}), 1) << depth;
        EXPECT_LE(layers.least_above(NearestTexels{4, false}), 0.75f)
            << depth << ": the test would pass anything";
    }
}

TEST(NearestTexels, OfTheOwnSurfaceGoOverEdgesThatDoNotBendFar) {
    // Facets at 60 degrees, one instance each: across their common edge, they count as one surface.
    Scene scene;
    add(scene, quad({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}), plain);
    add(scene, quad({0, 0, 0}, {0.5f, 0, std::sqrt(0.75f)}, {0, 1, 0}), plain);
    const PreparedTexels texels = texels_of(scene, 128);
    const std::uint32_t second = texels.layout.regions()[1].first_texel;
    const LightMap map =
        map_with(texels, NearestTexels{}, [&](std::uint32_t texel) { return texel < second ? 1 : 5; });
    const float at_the_edge = map.irradiance(front_of(scene, on_quad(0, 0.999f, 0.5f))).x;
    EXPECT_GT(at_the_edge, 1.5f);
    EXPECT_LT(at_the_edge, 4);
}

TEST(NearestTexels, OfTheOwnSurfaceAreThoseUnderItWhereItHasNone) {
    // Shreds far smaller than a texel share one, placed by face. Nearly all of it belongs to the larger
    // shred.
    Scene scene = floor_of(plain);
    Mesh shreds = joined(quad({5, 0, 0}, {2e-3f, 0, 0}, {0, 2e-3f, 0}),
                         quad({5.003f, 0, 0}, {1e-3f, 0, 0}, {0, 1e-3f, 0}));
    for (auto& texcoord : shreds.texcoord) texcoord.clear();
    add(scene, shreds, plain);
    const PreparedTexels texels(scene, shlm::find_lightmap_uv(scene), 100, shlm::TexelPlacement::automatic);
    const LightMap map = map_of_one(texels, NearestTexels{}, 3);
    for (const std::uint32_t shred : {2, 4})
        EXPECT_FLOAT_EQ(map.irradiance(front_of(scene, on_quad(shred, 0.3f, 0.6f))).x, 3) << shred;
}

TEST(NearestTexels, HoldCoveredTexelsOnlyWithTheirCentresAndIndex) {
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangle.resize(1);
    Scene scene;
    add(scene, mesh, plain);
    const PreparedTexels texels = texels_of(scene, 20'000);
    std::vector<Vec3> centers;
    for (const TexelGeometry& texel : texels.geometry)
        if (texel.area > 0) centers.push_back(texel.center);
    ASSERT_LT(static_cast<double>(centers.size()), 0.6 * static_cast<double>(texels.layout.texel_count()));
    const LightMap map = map_of_one(texels, NearestTexels{});
    ASSERT_EQ(map.texels().size(), centers.size());
    const std::size_t own =
        centers.size() * (sizeof(map.texels()[0]) + sizeof(Vec3) + sizeof(std::uint32_t)) +
        texels.pieces->bytes();
    // The index is measured at the allocator, which rounds sizes.
    const auto index = static_cast<double>(common::FlannIndex(centers).bytes());
    ASSERT_GT(index, 0);
    EXPECT_NEAR(static_cast<double>(map.bytes() - own), index, 0.02 * index);
}

TEST(StoredTexel, OneThatLooksNowhereIsFacedByNobodyInHalvesEither) {
    const shlm::TexelFace nowhere{Vec3(0, 0, 0), 1}, up{Vec3(0, 0, 1), 1};
    EXPECT_EQ(shlm::PackedFace(nowhere, 1).unpacked().area, 0);
    EXPECT_EQ(shlm::PackedFace(up, 1).unpacked().area, 0xffff);
}

}  // namespace
