#include "shlm/layout/face_charts.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

#include "shlm/layout/prepared_texels.h"
#include "shlm/layout/texel_places.h"
#include "tests/support/scene_builder.h"

namespace {

using namespace tests;
using shlm::PreparedTexels;
using shlm::TexelChart;
using shlm::TexelPlacement;

const Material plain = diffuse(Rgb(0.5f, 0.5f, 0.5f));

Scene scene_of(const Mesh& mesh, const Material& material = plain) {
    Scene scene;
    add(scene, mesh, material);
    return scene;
}

PreparedTexels by_face(const Scene& scene, std::size_t wanted) {
    return {scene, shlm::find_lightmap_uv(scene), wanted, TexelPlacement::face};
}

double surface_area(const Scene& scene) {
    double area = 0;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) area += common::triangle_area(scene, t);
    return area;
}

double area_of(const PreparedTexels& texels) {
    double area = 0;
    for (const shlm::TexelGeometry& texel : texels.geometry) area += texel.area;
    return area;
}

/// Makes a grid of n x n cells over (u, v) in the unit square, with two triangles each and no shared
/// vertices.
template <class Surface>
Mesh grid_of(int n, Surface surface) {
    Mesh mesh;
    const auto add_triangle = [&](std::array<std::array<int, 2>, 3> corners) {
        const auto first = static_cast<std::uint32_t>(mesh.position.size());
        for (const auto& [i, j] : corners)
            mesh.position.push_back(surface(static_cast<float>(i) / static_cast<float>(n),
                                            static_cast<float>(j) / static_cast<float>(n)));
        mesh.triangle.push_back({first, first + 1, first + 2});
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            add_triangle({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
            add_triangle({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
    mesh.texcoord[1].assign(mesh.position.size(), Vec2(0, 0));
    return mesh;
}

Mesh flat_grid(int n) {
    return grid_of(n, [](float u, float v) { return Vec3(2 * u, v, 0); });
}

/// Makes an open cylinder with its axis along y; radius and height are 1.
Mesh cylinder(int n) {
    return grid_of(n, [](float u, float v) {
        const double angle = 2 * pi * u;
        return Vec3(static_cast<float>(std::cos(angle)), 1 - v, static_cast<float>(std::sin(angle)));
    });
}

/// Makes triangles of this size at random positions in the unit cube, with random orientations.
Mesh confetti(int count, float size) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto random = [&] { return Vec3(uniform(engine), uniform(engine), uniform(engine)); };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 center = random() * 0.5f;
        const auto first = static_cast<std::uint32_t>(mesh.position.size());
        for (int corner = 0; corner < 3; ++corner) mesh.position.push_back(center + random() * size);
        mesh.triangle.push_back({first, first + 1, first + 2});
    }
    mesh.texcoord[1].assign(mesh.position.size(), Vec2(0, 0));
    return mesh;
}

/// Makes a square with a square hole, whose rim is a tenth wide on each side.
Mesh frame() {
    Mesh mesh = joined(quad({0, 0, 0}, {1, 0, 0}, {0, 0.1f, 0}), quad({0, 0.9f, 0}, {1, 0, 0}, {0, 0.1f, 0}));
    mesh = joined(mesh, quad({0, 0.1f, 0}, {0.1f, 0, 0}, {0, 0.8f, 0}));
    return joined(mesh, quad({0.9f, 0.1f, 0}, {0.1f, 0, 0}, {0, 0.8f, 0}));
}

TEST(FaceCharts, HoldEachTriangleOnceWithAllItsArea) {
    for (const Mesh& mesh : {flat_grid(30), cylinder(40), confetti(2000, 0.05f), frame()})
        for (const std::size_t wanted : {10, 1000, 30'000}) {
            const Scene scene = scene_of(mesh);
            const auto charts =
                shlm::texel_charts(scene, shlm::find_lightmap_uv(scene), TexelPlacement::face, wanted);
            std::vector<int> held(scene.triangle.size(), 0);
            for (const TexelChart& chart : charts) {
                ASSERT_EQ(chart.triangle.size(), chart.corner.size());
                for (const std::uint32_t triangle : chart.triangle) ++held.at(triangle);
                for (const auto& corners : chart.corner)
                    for (const Vec2& corner : corners) {
                        EXPECT_GE(std::min(corner.x, corner.y), -1e-6f);
                        EXPECT_LE(std::max(corner.x, corner.y), 1 + 1e-6f);
                    }
            }
            EXPECT_EQ(std::count(held.begin(), held.end(), 1), std::ssize(held));
            const double area = surface_area(scene);
            EXPECT_NEAR(area_of(by_face(scene, wanted)), area, 1e-5 * area) << wanted;
        }
}

TEST(FaceCharts, AFlatWallOfManyTrianglesIsOneRectangle) {
    const Scene scene = scene_of(flat_grid(50));
    const PreparedTexels texels = by_face(scene, 800);
    ASSERT_EQ(texels.layout.regions().size(), 1u);
    const shlm::TexelRegion& region = texels.layout.regions()[0];
    EXPECT_EQ(std::max(region.width, region.height), 40u);
    EXPECT_EQ(std::min(region.width, region.height), 20u);
    for (const shlm::TexelGeometry& texel : texels.geometry) EXPECT_NEAR(texel.area, 0.05 * 0.05, 1e-6);
}

TEST(FaceCharts, SayByPositionWhereHitsAreTaken) {
    const Vec3 far_away(1000, -2000, 500);
    Mesh moved = cylinder(40);
    for (Vec3& position : moved.position) position += far_away;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit;
    for (const auto& [mesh, rounding] : {std::pair(flat_grid(30), 1e-4f),
                                         {cylinder(40), 1e-4f},
                                         {confetti(2000, 0.05f), 1e-4f},
                                         {frame(), 1e-4f},
                                         {moved, 0.1f}}) {
        const Scene scene = scene_of(mesh);
        const PreparedTexels texels = by_face(scene, 5000);
        const shlm::TexelPlaces places(texels.layout);
        EXPECT_EQ(places.bytes(),
                  scene.triangle.size() * 4 +
                      texels.layout.regions().size() * (sizeof(shlm::TexelRegion) + 9 * sizeof(float)));
        for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
            const float s = unit(random), u = s * unit(random), v = s - u;
            common::SurfacePoint point{{t, u, v}, {}, scene.geometric_normal[t], scene.geometric_normal[t]};
            point.position = common::position_at(scene, point.surface);
            const shlm::TriangleTexels& texel = texels.layout.triangle(t);
            const Vec2 expected = texel.corner + texel.edge_u * u + texel.edge_v * v;
            const auto place = places.find(point);
            ASSERT_TRUE(place);
            EXPECT_LT((place->at - expected).length(), rounding);
            EXPECT_EQ(places.region(*place).first_texel, texel.first_texel);
            point.front = false;
            EXPECT_FALSE(places.find(point)) << "no texels on the back";
        }
    }
}

TEST(FaceCharts, RepeatedVerticesMakeNoDifference) {
    const Mesh repeated = cylinder(24);
    Mesh shared;  // each position once
    std::map<std::array<float, 3>, std::uint32_t> number;
    for (const auto& triangle : repeated.triangle) {
        auto& corners = shared.triangle.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = repeated.position[triangle[i]];
            const auto [at, is_new] =
                number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(shared.position.size()));
            if (is_new) shared.position.push_back(p);
            corners[i] = at->second;
        }
    }
    shared.texcoord[1].assign(shared.position.size(), Vec2(0, 0));
    const Scene a = scene_of(repeated), b = scene_of(shared);
    const PreparedTexels of_a = by_face(a, 3000), of_b = by_face(b, 3000);
    ASSERT_EQ(of_a.geometry.size(), of_b.geometry.size());
    for (std::size_t i = 0; i < of_a.geometry.size(); ++i)
        ASSERT_EQ(of_a.geometry[i].area, of_b.geometry[i].area);
}

/// Returns the charts of all triangles of the scene.
std::vector<TexelChart> charts_of_all(const Scene& scene, double texel_size) {
    std::vector<std::uint32_t> all(scene.triangle.size());
    std::iota(all.begin(), all.end(), 0u);
    return shlm::face_charts(scene, all, false, texel_size);
}

TEST(FaceCharts, ATriangleByItselfCoversHalfItsRectangle) {
    Mesh mesh;
    mesh.position = {{0, 0, 0}, {5, 0, 0}, {1, 0, 2}};
    mesh.triangle = {{0, 1, 2}};
    mesh.texcoord[1].assign(3, Vec2(0, 0));
    const Scene scene = scene_of(mesh);
    const auto charts = charts_of_all(scene, 0.01);
    ASSERT_EQ(charts.size(), 1u);
    EXPECT_NEAR(charts[0].width * charts[0].height, 2 * surface_area(scene), 1e-6);
}

TEST(FaceCharts, FillAtLeastHalfTheirRectangles) {
    const Scene scene = scene_of(frame());
    double rectangles = 0;
    for (const TexelChart& chart : charts_of_all(scene, 0.001)) rectangles += chart.width * chart.height;
    EXPECT_LE(rectangles, 2 * surface_area(scene));
}

TEST(FaceCharts, WallsThatMeetOrFaceApartAreNotJoined) {
    EXPECT_EQ(by_face(closed_box(plain), 6000).layout.regions().size(), 6u);

    // Two sheets closer than a texel that face away from each other, joined at an edge.
    Mesh sheets = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    sheets = joined(sheets, quad({0, 0, -1e-4f}, {0, 1, 0}, {1, 0, 0}));
    EXPECT_EQ(by_face(scene_of(sheets), 200).layout.regions().size(), 2u);
}

TEST(FaceCharts, BendNoFurtherThanHalfATexel) {
    const Scene scene = scene_of(cylinder(200));
    constexpr double texel_size = 0.02;
    for (const TexelChart& chart : charts_of_all(scene, texel_size)) {
        const Vec3& normal = scene.geometric_normal[chart.triangle.front()];
        double least = 1e30, most = -1e30;
        for (const std::uint32_t t : chart.triangle) {
            EXPECT_GE(scene.geometric_normal[t].dot(normal), 0.6f);
            for (const std::uint32_t vertex : scene.triangle[t]) {
                least = std::min<double>(least, scene.position[vertex].dot(normal));
                most = std::max<double>(most, scene.position[vertex].dot(normal));
            }
        }
        EXPECT_LE(most - least, 2 * texel_size);
    }
}

TEST(FaceCharts, TrianglesSmallerThanATexelShareThem) {
    const Scene scene = scene_of(confetti(100'000, 1e-3f));
    for (const std::size_t wanted : {1000, 10'000}) {
        const PreparedTexels texels = by_face(scene, wanted);
        EXPECT_LE(texels.layout.texel_count(), wanted + wanted / 5);
        EXPECT_GE(texels.layout.texel_count(), wanted / 4);
    }
}

TEST(FaceCharts, BacksHaveTexelsOfTheirOwn) {
    const PreparedTexels texels = by_face(scene_of(flat_grid(3), double_sided(plain)), 400);
    ASSERT_EQ(texels.layout.regions().size(), 1u);
    EXPECT_EQ(texels.layout.texel_count(), 400u);
    EXPECT_NEAR(area_of(texels), 2 * 2, 1e-4);
    EXPECT_EQ(texels.geometry[0].normal, -texels.geometry[200].normal);
}

TEST(TexelPlacement, TakesFacesWhereCoordinatesAreMissingOrOverlap) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), plain);
    Mesh twice = quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    twice = joined(twice, quad({2, 0, 1}, {1, 0, 0}, {0, 1, 0}));
    add(scene, twice, plain);
    Mesh none = quad({0, 0, 2}, {1, 0, 0}, {0, 1, 0});
    none.texcoord[1].assign(4, Vec2(0, 0));
    add(scene, none, plain);
    add(scene, quad({0, 0, 3}, {1, 0, 0}, {0, 1, 0}), mirror());
    const auto uv = shlm::find_lightmap_uv(scene);

    std::vector<bool> by_uv;
    for (const shlm::LightmapUv& one : uv) by_uv.push_back(placed_by_uv(one, TexelPlacement::automatic));
    EXPECT_EQ(by_uv, (std::vector<bool>{true, true, false, false}))
        << "one of the two that overlap keeps its place";

    const PreparedTexels automatic(scene, uv, 400, TexelPlacement::automatic);
    EXPECT_NEAR(area_of(automatic), 4, 1e-4) << "all but the mirror";
    EXPECT_EQ(automatic.layout.regions().size(), 4u)
        << "the two quads that overlap have one each, by coordinates and by face";
    EXPECT_EQ(automatic.layout.triangle(6 + 2).width, 0u) << "nothing is stored on mirrors";

    const PreparedTexels only_uv(scene, uv, 400, TexelPlacement::uv);
    EXPECT_NEAR(area_of(only_uv), 3, 1e-4) << "without the quad that has no coordinates";
}

}  // namespace
