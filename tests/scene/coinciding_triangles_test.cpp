// Tests which triangles lie over others in the same plane, and the area of the overlap.
#include "common/scene/coinciding_triangles.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "common/core/threads.h"
#include "common/scene/triangle_overlap.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::CoincidingTriangles;
using common::common_area;
using common::TriangleCorners;

/// A few rounding errors for scenes whose coordinates are a few units.
constexpr float tolerance = 4e-6f;

const Material plain = diffuse(Rgb(0.5f, 0.5f, 0.5f));

CoincidingTriangles found_in(const Scene& scene) {
    return common::find_coinciding_triangles(scene, tolerance);
}

std::vector<std::uint32_t> first_triangles(std::uint32_t count) {
    std::vector<std::uint32_t> all(count);
    for (std::uint32_t t = 0; t < count; ++t) all[t] = t;
    return all;
}

Scene scene_of(std::initializer_list<Mesh> meshes, const Material& material = plain) {
    Scene scene;
    for (const Mesh& mesh : meshes) add(scene, mesh, material);
    return scene;
}

Mesh other_diagonal(Mesh quad) {
    quad.triangle = {{0, 1, 3}, {1, 2, 3}};
    return quad;
}

Mesh reversed(Mesh mesh) {
    for (common::TriangleVertices& corners : mesh.triangle) std::swap(corners[1], corners[2]);
    return mesh;
}

/// Makes `side` x `side` quads with separate vertices.
Mesh tiles(int side) {
    Mesh all{"tiles", {}, {}, {}, {}, 1, {}};
    const auto at = [side](int i) { return static_cast<float>(i) / static_cast<float>(side); };
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const auto first = static_cast<std::uint32_t>(all.position.size());
            for (const auto& [x, y] : {std::pair(i, j), {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
                all.position.push_back({at(x), at(y), 0});
            all.triangle.push_back({first, first + 1, first + 2});
            all.triangle.push_back({first, first + 2, first + 3});
        }
    return all;
}

const Mesh unit_quad = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

// --- two triangles

TriangleCorners triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {a, b, c};
}

TEST(CommonArea, OfTrianglesInOnePlane) {
    const TriangleCorners a = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_DOUBLE_EQ(common_area(a, a, 1e-6), 0.5);
    EXPECT_DOUBLE_EQ(common_area(a, triangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), 1e-6), 0.5) << "reversed";
    EXPECT_DOUBLE_EQ(common_area(a, triangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}), 1e-6), 0.25);
    EXPECT_DOUBLE_EQ(common_area(a, triangle({0.25, 0.25, 0}, {0.5, 0.25, 0}, {0.25, 0.5, 0}), 1e-6),
                     0.03125);
    // The overlap is the hexagon in the middle of a six-pointed star: two thirds of a triangle's area.
    const float h = std::sqrt(3.0f);
    const TriangleCorners up = triangle({-1, 0, 0}, {1, 0, 0}, {0, h, 0}),
                          down = triangle({-1, h * 2 / 3, 0}, {0, -h / 3, 0}, {1, h * 2 / 3, 0});
    EXPECT_NEAR(common_area(up, down, 1e-6), std::sqrt(3.0) * 2 / 3, 1e-6);
}

TEST(CommonArea, NeedsAnOverlapAndOnePlane) {
    const TriangleCorners a = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto moved_by = [&](const Vec3& offset) {
        return triangle(a[0] + offset, a[1] + offset, a[2] + offset);
    };
    constexpr double near = 1e-3;
    EXPECT_EQ(common_area(a, triangle({1, 0, 0}, {1, 1, 0}, {0, 1, 0}), near), 0) << "they share an edge";
    EXPECT_EQ(common_area(a, moved_by({2, 0, 0}), near), 0);
    EXPECT_EQ(common_area(a, moved_by({0.9995f, 0, 0}), near), 0) << "less than the tolerance";
    EXPECT_GT(common_area(a, moved_by({0.99f, 0, 0}), near), 0);
    EXPECT_EQ(common_area(a, moved_by({0, 0, 0.0011f}), near), 0);
    EXPECT_GT(common_area(a, moved_by({0, 0, 0.0009f}), near), 0);
    EXPECT_EQ(common_area(a, triangle({0, 0, -0.5f}, {1, 0, 0.5f}, {0, 1, 0}), near), 0) << "they cross";
    EXPECT_EQ(common_area(a, triangle({0, 0, 0}, {1, 0, 0}, {0.5f, 0, 1}), near), 0) << "it stands on it";
    EXPECT_EQ(common_area(a, triangle({0, 0, 0}, {1, 0, 0}, {0.5f, 0.0009f, 0}), near), 0) << "too narrow";
}

// --- none

TEST(CoincidingTriangles, AreNotFoundInScenesWithoutAny) {
    for (const Scene& scene : {closed_box(plain), scene_of({sphere({1, 2, 3}, 1, 5)}), scene_of({tiles(71)}),
                               moved(scene_of({tiles(71)}), skew_rotation(), {1, -2, 0.5f}), Scene{}}) {
        const CoincidingTriangles found = found_in(scene);
        EXPECT_TRUE(found.triangle.empty());
        EXPECT_EQ(found.covering, 0u);
        EXPECT_EQ(found.area, 0);
        EXPECT_TRUE(found.all_compared);
    }
}

TEST(CoincidingTriangles, NeighboursOfOtherSizesAreNone) {
    Scene scene = scene_of({tiles(3)});
    add(scene, quad({1, 0, 0}, {0.5f, 0, 0}, {0, 1, 0}), plain);  // corners of the tiles lie on its side
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), plain);     // stands on them
    EXPECT_TRUE(found_in(moved(scene, skew_rotation(), {1, 1, 1})).triangle.empty());
}

TEST(CoincidingTriangles, NearPlanesAreNone) {
    EXPECT_TRUE(
        found_in(scene_of({unit_quad, quad({0, 0, 2 * tolerance}, {1, 0, 0}, {0, 1, 0})})).triangle.empty());
    EXPECT_EQ(
        found_in(scene_of({unit_quad, quad({0, 0, tolerance / 2}, {1, 0, 0}, {0, 1, 0})})).triangle.size(),
        4u);
}

// --- some

/// Expects the result in random orientations, which include normals at the borders of the search's cells.
void expect_found(const Scene& scene, std::size_t triangles, std::size_t covering, double area) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> turn(0, 6.28f);
    for (int i = 0; i < 100; ++i) {
        Imath::M44f rotation;
        const float eighth = 0.25f * static_cast<float>(pi);
        if (i < 64)
            rotation.rotate(Vec3(static_cast<float>(i % 8), static_cast<float>(i / 8), 0) * eighth);
        else
            rotation.rotate(Vec3(turn(engine), turn(engine), turn(engine)));
        const CoincidingTriangles found = found_in(moved(scene, rotation, {1, -0.5f, 0.25f}));
        ASSERT_EQ(found.triangle.size(), triangles) << "turn " << i;
        ASSERT_EQ(found.covering, covering) << "turn " << i;
        ASSERT_NEAR(found.area, area, 1e-5) << "turn " << i;
        ASSERT_TRUE(found.all_compared);
    }
}

TEST(CoincidingTriangles, QuadsSplitAlongTheOtherDiagonal) {
    expect_found(scene_of({unit_quad, other_diagonal(unit_quad)}), 4, 2, 1);
}

TEST(CoincidingTriangles, SmallQuadInTheMiddleOfALargeOne) {
    const Mesh small = quad({0.45f, 0.45f, 0}, {0.1f, 0, 0}, {0, 0.1f, 0});
    expect_found(scene_of({unit_quad, small}), 4, 2, 0.01);
    expect_found(scene_of({small, unit_quad}), 4, 2, 0.01);
    expect_found(scene_of({unit_quad, quad({0.7f, 0.2f, 0}, {0.005f, 0, 0}, {0, 0.002f, 0})}), 3, 2, 1e-5);
}

TEST(CoincidingTriangles, BackToBackNoneLiesOverTheOther) {
    expect_found(scene_of({unit_quad, reversed(unit_quad)}), 4, 0, 0);
    expect_found(scene_of({unit_quad, reversed(unit_quad)}, double_sided(plain)), 4, 2, 1);
    expect_found(scene_of({unit_quad, reversed(unit_quad)}, glass()), 4, 2, 1);
}

TEST(CoincidingTriangles, AreasCountOnce) {
    expect_found(scene_of({unit_quad, unit_quad, unit_quad}), 6, 4, 2);
}

/// Makes triangles of all sizes in three planes.
Scene random_triangles(std::uint32_t count) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Mesh> planes(3, Mesh{"plane", {}, {}, {}, {}, 1, {}});
    for (std::uint32_t i = 0; i < count; ++i) {
        Mesh& plane = planes[i % 3];
        const auto first = static_cast<std::uint32_t>(plane.position.size());
        const float size = std::pow(uniform(engine), 3.0f), x = uniform(engine), y = uniform(engine);
        for (int corner = 0; corner < 3; ++corner)
            plane.position.push_back(
                {x + size * uniform(engine), y + size * uniform(engine), 0.5f * static_cast<float>(i % 3)});
        plane.triangle.push_back({first, first + 1, first + 2});
    }
    Scene scene;
    for (const Mesh& plane : planes) add(scene, plane, plain);
    return moved(scene, skew_rotation(), {0, 0, 0});
}

TEST(CoincidingTriangles, AreThoseOfABruteSearchOnAnyNumberOfThreads) {
    const Scene scene = random_triangles(600);
    const auto corners = [&](std::uint32_t t) {
        const auto [a, b, c] = scene.triangle[t];
        return triangle(scene.position[a], scene.position[b], scene.position[c]);
    };
    std::set<std::uint32_t> expected;
    std::size_t covering = 0;
    double area = 0;
    for (std::uint32_t after = 0; after < scene.triangle.size(); ++after) {
        double of_one = 0;
        for (std::uint32_t before = 0; before < after; ++before) {
            const double common = common_area(corners(before), corners(after), double{tolerance});
            if (common == 0) continue;
            expected.insert({before, after});
            if (scene.geometric_normal[before].dot(scene.geometric_normal[after]) > 0) of_one += common;
        }
        covering += of_one > 0;
        area += std::min(of_one, double{common::triangle_area(scene, after)});
    }
    ASSERT_GT(expected.size(), 300u);
    for (const int threads : {1, 2, 7}) {
        CoincidingTriangles found;
        common::ThreadPool(threads).run([&] { found = found_in(scene); });
        EXPECT_EQ(found.triangle, std::vector(expected.begin(), expected.end()));
        EXPECT_EQ(found.covering, covering);
        EXPECT_NEAR(found.area, area, 1e-9);
        EXPECT_TRUE(found.all_compared);
    }
}

// All overlap: comparing each with each takes seconds here, and minutes for larger numbers.
TEST(CoincidingTriangles, AreTakenForItWhereTheyAreTooManyToCompare) {
    constexpr std::uint32_t count = 3000;
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> uniform(0, 0.1f);
    Mesh heap{"heap", {}, {}, {}, {}, 1, {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
            heap.position.push_back(corner + Vec3(uniform(engine), uniform(engine), 0));
        heap.triangle.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    Scene scene = scene_of({heap});
    add(scene, quad({5, 0, 0}, {1, 0, 0}, {0, 0, 1}), plain);
    const CoincidingTriangles found = found_in(scene);
    EXPECT_EQ(found.triangle, first_triangles(count));
    EXPECT_FALSE(found.all_compared);
}

}  // namespace
