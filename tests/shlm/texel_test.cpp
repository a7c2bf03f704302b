#include <gtest/gtest.h>

#include <random>

#include "shlm/layout/texel_charts.h"
#include "shlm/layout/texel_geometry.h"
#include "shlm/layout/texel_layout.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using shlm::LightmapUv;
using shlm::TexelGeometry;
using shlm::TexelLayout;

const Material plain = diffuse(Rgb(0.5f, 0.5f, 0.5f));

TexelLayout layout_of(const Scene& scene, std::size_t wanted) {
    const auto uv = shlm::find_lightmap_uv(scene);
    return {scene, shlm::texel_charts(scene, uv, shlm::TexelPlacement::uv, wanted), wanted};
}

struct Texels {
    Texels(const Scene& scene, std::size_t wanted) : Texels(scene, shlm::find_lightmap_uv(scene), wanted) {}
    Texels(const Scene& scene, std::vector<LightmapUv> examined, std::size_t wanted)
        : uv(std::move(examined)),
          layout(scene, shlm::texel_charts(scene, uv, shlm::TexelPlacement::uv, wanted), wanted),
          geometry(shlm::texel_geometry(scene, layout, common::SurfacePieces(scene))) {}

    std::vector<LightmapUv> uv;
    TexelLayout layout;
    std::vector<TexelGeometry> geometry;
};

double surface_area(const Scene& scene, const common::MeshInstance& instance) {
    double area = 0;
    for (std::uint32_t t = 0; t < instance.triangle_count; ++t)
        area += common::triangle_area(scene, instance.first_triangle + t);
    return area;
}

double area_of(std::span<const TexelGeometry> texels) {
    double area = 0;
    for (const TexelGeometry& texel : texels) area += texel.area;
    return area;
}

void expect_whole_surface(const Scene& scene, std::initializer_list<std::size_t> counts, const char* what) {
    const std::vector<LightmapUv> uv = shlm::find_lightmap_uv(scene);
    for (const std::size_t wanted : counts) {
        const Texels texels(scene, uv, wanted);
        for (std::size_t i = 0; i < scene.instance.size(); ++i) {
            const shlm::TexelRegion& region = texels.layout.regions()[i];
            const std::size_t count = region.texels_per_face();
            ASSERT_GT(count, 0u) << what;
            const auto faces = std::span(texels.geometry).subspan(region.first_texel);
            const double expected = surface_area(scene, scene.instance[i]);
            EXPECT_NEAR(area_of(faces.first(count)), expected, 1e-5 * expected)
                << what << ", " << wanted << " texels";
            if (region.both_faces) {
                EXPECT_NEAR(area_of(faces.subspan(count, count)), expected, 1e-5 * expected)
                    << what << ", backs";
            }
        }
    }
}

/// Returns the corners of a plane mesh, mapped by a similarity matrix: lightmap coordinates that keep every
/// triangle's shape.
std::vector<Vec2> planar_uv(const std::vector<Vec3>& position, double angle, float scale,
                            const Vec2& offset) {
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    std::vector<Vec2> uv;
    for (const Vec3& p : position) uv.push_back(Vec2(c * p.x - s * p.y, s * p.x + c * p.y) * scale + offset);
    return uv;
}

/// Makes a square of 2 n^2 triangles whose inner corners are displaced by up to `jitter` cells.
Mesh shaken_grid(std::uint32_t n, double jitter, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> shake(-jitter, jitter);
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const bool inner = i > 0 && j > 0 && i < n && j < n;
            const double x = (i + (inner ? shake(engine) : 0)) / n, y = (j + (inner ? shake(engine) : 0)) / n;
            mesh.position.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
            mesh.triangle.push_back({a, b, c});
            mesh.triangle.push_back({a, c, d});
        }
    mesh.texcoord[1] = planar_uv(mesh.position, 0, 1, {0, 0});
    return mesh;
}

/// Makes a square as a fan of slivers from one corner.
Mesh slivers(int count) {
    Mesh mesh;
    mesh.position.emplace_back(0.0f, 0.0f, 0.0f);
    for (int i = 0; i <= count; ++i)
        mesh.position.emplace_back(1.0f, static_cast<float>(i) / static_cast<float>(count), 0.0f);
    for (std::uint32_t i = 1; i <= static_cast<std::uint32_t>(count); ++i)
        mesh.triangle.push_back({0, i, i + 1});
    mesh.texcoord[1] = planar_uv(mesh.position, 0, 1, {0, 0});
    return mesh;
}

Scene scene_of(const Mesh& mesh, const Material& material = plain) {
    Scene scene;
    add(scene, mesh, material);
    return scene;
}

/// Returns the number of triangles along a side: fewer in builds where each takes long.
int few_or(int many) {
    return static_cast<int>(
        count_for(static_cast<std::uint64_t>(many), static_cast<std::uint64_t>(many) / 5));
}

TEST(TexelGeometry, AreasAddUpToTheSurface) {
    const auto counts = {std::size_t{1}, std::size_t{7}, std::size_t{100}, std::size_t{10'000}};
    expect_whole_surface(closed_box(plain), counts, "box");
    expect_whole_surface(scene_of(quad({0, 0, 0}, {1, 0, 0}, {0, 3, 0}), double_sided(plain)), counts,
                         "both faces");
    expect_whole_surface(scene_of(shaken_grid(20, 0.4, 1)), counts, "shaken grid");
    expect_whole_surface(scene_of(slivers(few_or(1000))), counts, "slivers");
    expect_whole_surface(scene_of(shaken_grid(few_or(150), 0.3, 2)), counts,
                         "triangles smaller than a texel");
}

TEST(TexelGeometry, AreasAddUpForChartsOffTheGrid) {
    for (const double angle : {0.0, 0.3, pi / 4, 2.0})
        for (const float scale :
             {0.37f, -0.21f, 25.0f}) {  // a negative scale turns, a factor makes a mirror image
            Mesh mesh = shaken_grid(7, 0.4, 3);
            mesh.texcoord[1] = planar_uv(mesh.position, angle, scale, {0.123f, -4.56f});
            expect_whole_surface(scene_of(mesh), {1000}, "turned chart");
            for (Vec2& uv : mesh.texcoord[1]) uv.x *= -3;
            expect_whole_surface(scene_of(mesh), {1000}, "mirrored, stretched chart");
        }
}

TEST(TexelGeometry, AreasAddUpForUnevenMaps) {
    // Corners are displaced differently in space and in the map: each triangle has its own scale and shear.
    Mesh mesh = shaken_grid(30, 0.3, 4);
    mesh.texcoord[1] = shaken_grid(30, 0.3, 5).texcoord[1];
    for (std::size_t i = 0; i < mesh.position.size(); ++i)
        mesh.position[i].z = 0.2f * std::sin(7 * mesh.position[i].x);
    expect_whole_surface(scene_of(mesh), {50, 5000}, "uneven map");
}

TEST(TexelGeometry, AreasAddUpForSmallAndLargeScenes) {
    for (const float scale : {1e-4f, 1e4f}) {
        Mesh mesh = shaken_grid(10, 0.3, 6);
        for (Vec3& p : mesh.position) p = p * scale + Vec3(10 * scale, 0, 0);
        expect_whole_surface(scene_of(mesh), {1000}, "scaled");
    }
}

TEST(TexelGeometry, KnowsCentreAndNormalOfEachTexel) {
    const Scene scene = scene_of(quad({0, 0, 2}, {4, 0, 0}, {0, 4, 0}), double_sided(plain));
    const Texels texels(scene, 32);
    ASSERT_EQ(texels.layout.texel_count(), 32u);
    for (std::uint32_t face = 0; face < 2; ++face)
        for (std::uint32_t y = 0; y < 4; ++y)
            for (std::uint32_t x = 0; x < 4; ++x) {
                const TexelGeometry& texel = texels.geometry[16 * face + 4 * y + x];
                const Vec3 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 2);
                EXPECT_LT((texel.center - center).length(), 1e-5f);
                EXPECT_EQ(texel.normal, Vec3(0, 0, face == 0 ? 1 : -1));
                EXPECT_NEAR(texel.area, 1, 1e-5);
            }
}

TEST(TexelGeometry, CentresLieOnTheCoveredPart) {
    Mesh mesh = shaken_grid(13, 0.2, 7);
    mesh.texcoord[1] = planar_uv(mesh.position, 0.5, 0.7f, {0.1f, 0.2f});
    const Texels texels(scene_of(mesh), 3000);
    // The chart keeps shapes: a texel is a square whose side is the square root of the largest area.
    float largest = 0;
    for (const TexelGeometry& texel : texels.geometry) largest = std::max(largest, texel.area);
    std::size_t covered = 0;
    for (const TexelGeometry& texel : texels.geometry) {
        if (texel.area == 0) continue;
        ++covered;
        EXPECT_NEAR(texel.normal.z, 1, 1e-6);
        EXPECT_GE(std::min(texel.center.x, texel.center.y), -1e-4f);
        EXPECT_LE(std::max(texel.center.x, texel.center.y), 1 + 1e-4f);
    }
    EXPECT_GE(static_cast<double>(covered) * largest, 0.999);
    EXPECT_LE(static_cast<double>(covered) * largest, 1.2)
        << "no more than a rim of texels is covered in part";
}

TEST(TexelLayout, GivesAboutAsManyTexelsAsAreWanted) {
    std::mt19937 engine(8);
    std::uniform_real_distribution<float> size(0.2f, 3);
    Scene scene;
    for (int i = 0; i < 40; ++i) {
        const float width = size(engine), height = size(engine);
        add(scene, quad({0, 0, static_cast<float>(i)}, {width, 0, 0}, {0, height, 0}),
            i % 2 ? plain : double_sided(plain));
    }
    for (const std::size_t wanted : {1000, 10'000, 262'144}) {
        const TexelLayout layout = layout_of(scene, wanted);
        EXPECT_LE(layout.texel_count(), wanted);
        EXPECT_GE(static_cast<double>(layout.texel_count()), 0.95 * static_cast<double>(wanted));
    }
    EXPECT_GE(layout_of(scene, 10).texel_count(), 60u) << "one for each face at least";
}

TEST(TexelLayout, GivesTexelsInProportionToTheArea) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), plain);
    add(scene, quad({0, 0, 1}, {4, 0, 0}, {0, 1, 0}), plain);
    add(scene, quad({0, 0, 2}, {2, 0, 0}, {0, 2, 0}), double_sided(plain));
    const Texels texels(scene, 100 * (1 + 4 + 8));
    const auto regions = texels.layout.regions();
    EXPECT_NEAR(regions[0].width, 10, 1);
    EXPECT_NEAR(regions[0].height, 10, 1);
    EXPECT_NEAR(regions[1].width, 40, 1) << "texels are square in the world";
    EXPECT_NEAR(regions[1].height, 10, 1);
    EXPECT_NEAR(regions[2].width, 20, 1);
    EXPECT_NEAR(regions[2].height, 20, 1);
    EXPECT_TRUE(regions[2].both_faces);
}

TEST(TexelLayout, RegionsFillTheMapWithoutOverlap) {
    Scene scene = closed_box(plain);
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), mirror());
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), double_sided(plain));
    const Texels texels(scene, 1234);
    std::vector<int> owners(texels.layout.texel_count(), 0);
    for (const shlm::TexelRegion& region : texels.layout.regions())
        for (std::uint32_t k = 0; k < region.texels_per_face() * (region.both_faces ? 2 : 1); ++k)
            ++owners.at(region.first_texel + k);
    EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), static_cast<std::ptrdiff_t>(owners.size()));
    EXPECT_EQ(texels.layout.regions().size(), 7u) << "nothing is stored on mirrors";
}

TEST(TexelLayout, InstancesOfOneMeshHaveRegionsOfTheirOwn) {
    Scene scene;
    const Mesh mesh = shaken_grid(3, 0.2, 9);
    add(scene, mesh, plain);
    add(scene, mesh, plain);
    const Texels texels(scene, 200);
    const std::uint32_t second = scene.instance[1].first_triangle;
    EXPECT_NE(shlm::texel_at(texels.layout.triangle(0), 0.3f, 0.3f, true),
              shlm::texel_at(texels.layout.triangle(second), 0.3f, 0.3f, true));
    EXPECT_EQ(texels.uv[0].overlapping_area, 0);
    EXPECT_EQ(texels.uv[1].overlapping_area, 0);
}

/// Returns the position of a surface point in its region, in texels, from its lightmap coordinates.
Imath::V2d place_in_region(const Scene& scene, const Texels& texels, const SurfaceId& surface) {
    const std::uint32_t instance = scene.instance_of[surface.triangle];
    const shlm::TexelRegion& region = texels.layout.regions()[instance];
    const Imath::Box2f& bounds = texels.uv[instance].bounds;
    const Imath::V2d in_bounds = Imath::V2d(common::texcoord_at(scene, surface, 1)) - Imath::V2d(bounds.min);
    return {in_bounds.x / bounds.size().x * region.width, in_bounds.y / bounds.size().y * region.height};
}

void expect_points_in_their_texels(const Scene& scene, std::size_t wanted) {
    constexpr unsigned seed = 10;
    const Texels texels(scene, wanted);
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    int uncovered = 0;
    for (int i = 0; i < 20'000; ++i) {
        const float r1 = uniform(engine), r2 = uniform(engine);
        const Vec2 uv = common::sample_triangle(r1, r2);
        const SurfaceId surface{static_cast<std::uint32_t>(engine() % scene.triangle.size()), uv.x, uv.y};
        const shlm::TexelRegion& region = texels.layout.regions()[scene.instance_of[surface.triangle]];
        const std::uint32_t front =
            shlm::texel_at(texels.layout.triangle(surface.triangle), uv.x, uv.y, true);
        ASSERT_GE(front, region.first_texel);
        ASSERT_LT(front, region.first_texel + region.texels_per_face());
        const Imath::V2d place = place_in_region(scene, texels, surface);
        const std::uint32_t x = (front - region.first_texel) % region.width;
        const std::uint32_t y = (front - region.first_texel) / region.width;
        ASSERT_NEAR(place.x, x + 0.5, 0.501) << "seed " << seed;
        ASSERT_NEAR(place.y, y + 0.5, 0.501) << "seed " << seed;
        uncovered += texels.geometry[front].area == 0;
        if (!region.both_faces) continue;
        EXPECT_EQ(shlm::texel_at(texels.layout.triangle(surface.triangle), uv.x, uv.y, false),
                  front + region.texels_per_face());
    }
    EXPECT_LE(uncovered, 2)
        << "only rounding at a chart's border puts a point on a texel that nothing covers";
}

TEST(TexelLayout, FindsTheTexelThatAPointLiesIn) {
    expect_points_in_their_texels(closed_box(double_sided(plain)), 5000);
    Mesh mesh = shaken_grid(9, 0.4, 11);
    mesh.texcoord[1] = planar_uv(mesh.position, 0.6, 0.3f, {-0.7f, 5});
    expect_points_in_their_texels(scene_of(mesh), 5000);
    expect_points_in_their_texels(scene_of(slivers(200)), 5000);
}

TEST(TexelLayout, TrianglesWithoutMapAreaHaveNoTexels) {
    Mesh mesh = joined(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), quad({2, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    for (std::size_t i = 4; i < 8; ++i) mesh.texcoord[1][i] = {0.5f, 0.5f};
    const Texels texels(scene_of(mesh), 100);
    EXPECT_GT(texels.layout.triangle(0).width, 0u);
    EXPECT_EQ(texels.layout.triangle(2).width, 0u);
    EXPECT_NEAR(area_of(texels.geometry), 1, 1e-5);
}

// --- overlapping coordinates
// ---------------------------------------------------------------------------------------

const std::vector<Vec2> left_half = {{0, 0}, {0.5f, 0}, {0.5f, 1}, {0, 1}};
const std::vector<Vec2> right_half = {{0.5f, 0}, {1, 0}, {1, 1}, {0.5f, 1}};

Scene two_quads(const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
    return scene_of(joined(with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), first),
                           with_lightmap_uv(quad({5, 0, 0}, {1, 0, 0}, {0, 2, 0}), second)));
}

TEST(LightmapUv, NeighboursDoNotOverlap) {
    EXPECT_EQ(shlm::find_lightmap_uv(two_quads(left_half, right_half))[0].overlapping_area, 0);
    EXPECT_EQ(shlm::find_lightmap_uv(scene_of(shaken_grid(40, 0.2, 12)))[0].overlapping_area, 0);
    EXPECT_EQ(shlm::find_lightmap_uv(scene_of(slivers(300)))[0].overlapping_area, 0);
}

TEST(LightmapUv, MeasuresTheAreaThatSharesCoordinates) {
    const Scene whole = two_quads(left_half, left_half);
    EXPECT_NEAR(shlm::find_lightmap_uv(whole)[0].overlapping_area, 4, 0.02);
    EXPECT_EQ(shlm::describe_lightmap_trouble(whole, shlm::find_lightmap_uv(whole)).size(), 1u);
    // They overlap by a quarter of the width of each.
    const std::vector<Vec2> shifted = {{0.375f, 0}, {0.875f, 0}, {0.875f, 1}, {0.375f, 1}};
    EXPECT_NEAR(shlm::find_lightmap_uv(two_quads(left_half, shifted))[0].overlapping_area, 1, 0.02);
    // They overlap by two hundredths of the width of each, mirrored.
    const std::vector<Vec2> mirrored = {{0.99f, 0}, {0.49f, 0}, {0.49f, 1}, {0.99f, 1}};
    EXPECT_NEAR(shlm::find_lightmap_uv(two_quads(left_half, mirrored))[0].overlapping_area, 0.08, 0.02);
}

TEST(LightmapUv, MeasuresOverlapOfTrianglesSmallerThanItsGrid) {
    // Two dense sheets use the same tenth of the map, with triangles half a sample apart; a large quad lies
    // beside them.
    Mesh sheet = shaken_grid(100, 0, 13);
    for (Vec2& uv : sheet.texcoord[1]) uv *= 0.1f;
    const Mesh rest =
        with_lightmap_uv(quad({0, 0, 5}, {1, 0, 0}, {0, 1, 0}), {{0.2f, 0.2f}, {1, 0.2f}, {1, 1}, {0.2f, 1}});
    Mesh mesh = rest;
    mesh.texcoord[0].clear();
    mesh = joined(joined(mesh, sheet), sheet);
    EXPECT_NEAR(shlm::find_lightmap_uv(scene_of(mesh))[0].overlapping_area, 2, 0.1);
}

TEST(LightmapUv, SmallOverlapsOfAHugeMeshAreFound) {
    // A table top above a floor that is 10,000 times as large.
    const std::vector<Vec2> island = {{0.25f, 0.5f}, {0.255f, 0.5f}, {0.255f, 0.51f}, {0.25f, 0.51f}};
    const Scene scene =
        scene_of(joined(with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), left_half),
                        with_lightmap_uv(quad({5, 0, 0}, {0.01f, 0, 0}, {0, 0.02f, 0}), island)));
    const LightmapUv uv = shlm::find_lightmap_uv(scene)[0];
    EXPECT_EQ(uv.overlapping.triangle, (std::vector<std::uint32_t>{2, 3})) << "the smaller island";
    EXPECT_NEAR(uv.overlapping.area, 2e-4, 1e-8);
    EXPECT_TRUE(uv.is_lightmap());
}

TEST(LightmapUv, RoundingWhereChartsTouchIsNoOverlap) {
    // Charts in thirds and sevenths of the unit square, whose borders are rounded independently.
    Mesh mesh;
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 3; ++column) {
            const auto u = [&](int i) { return static_cast<float>(i) / 3; };
            const auto v = [&](int i) { return 1 - (7 - static_cast<float>(i)) * (1.0f / 7); };
            const float left = u(column), right = left + 1.0f / 3, low = v(row), high = low + 1.0f / 7;
            const Mesh chart =
                with_lightmap_uv(quad({5.0f * static_cast<float>(column), 5.0f * static_cast<float>(row), 0},
                                      {1, 0, 0}, {0, 1, 0}),
                                 {{left, low}, {right, low}, {right, high}, {left, high}});
            mesh = mesh.position.empty() ? chart : joined(mesh, chart);
        }
    const LightmapUv uv = shlm::find_lightmap_uv(scene_of(mesh))[0];
    EXPECT_EQ(uv.overlapping_area, 0);
    EXPECT_TRUE(uv.overlapping.triangle.empty());
    EXPECT_TRUE(uv.is_lightmap());
}

TEST(LightmapUv, CollapsedCoordinatesAreFound) {
    const Mesh good = with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), left_half);
    const auto with = [&](const std::vector<Vec2>& uv) {
        return shlm::find_lightmap_uv(
            scene_of(joined(good, with_lightmap_uv(quad({5, 0, 0}, {1, 0, 0}, {0, 1, 0}), uv))))[0];
    };
    const std::vector<Vec2> point(4, Vec2(0.7f, 0.5f)),
        line = {{0.7f, 0.1f}, {0.7f, 0.1f}, {0.7f, 0.9f}, {0.7f, 0.9f}},
        speck = {{0.7f, 0.5f}, {0.71f, 0.5f}, {0.71f, 0.51f}, {0.7f, 0.51f}},
        small = {{0.7f, 0.5f}, {0.75f, 0.5f}, {0.75f, 0.55f}, {0.7f, 0.55f}};
    for (const auto& uv : {point, line, speck}) {
        EXPECT_EQ(with(uv).collapsed.triangle, (std::vector<std::uint32_t>{2, 3}));
        EXPECT_NEAR(with(uv).collapsed.area, 1, 1e-6);
        EXPECT_TRUE(with(uv).is_lightmap());
    }
    EXPECT_TRUE(with(small).collapsed.triangle.empty())
        << "a hundredth of the median density is coarse, but some";
}

TEST(LightmapUv, CoordinatesMadeForColoursAreNoLightmap) {
    // A palette: each face has the place of its colour, a few thousandths wide, in an otherwise empty square.
    Mesh mesh;
    for (int i = 0; i < 40; ++i) {
        const float u = 0.1f + 0.2f * static_cast<float>(i % 5), v = 0.1f + 0.2f * static_cast<float>(i % 4),
                    w = 0.004f;
        const Mesh face = with_lightmap_uv(quad({2.0f * static_cast<float>(i), 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                           {{u, v}, {u + w, v}, {u + w, v + w}, {u, v + w}});
        mesh = mesh.position.empty() ? face : joined(mesh, face);
    }
    const Scene scene = scene_of(mesh);
    const auto uv = shlm::find_lightmap_uv(scene);
    EXPECT_FALSE(uv[0].is_lightmap());
    EXPECT_EQ(shlm::describe_useless_uv(scene, uv).size(), 1u);
    EXPECT_FALSE(shlm::placed_by_uv(uv[0], shlm::TexelPlacement::automatic));
}

TEST(LightmapUv, MirroredIslandsKeepOneOfEachPair) {
    Mesh mesh = with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), left_half);
    mesh = joined(mesh, with_lightmap_uv(quad({5, 0, 0}, {1, 0, 0}, {0, 1, 0}), right_half));
    mesh = joined(mesh, with_lightmap_uv(quad({9, 0, 0}, {1, 0, 0}, {0, 1, 0}), right_half));
    const LightmapUv uv = shlm::find_lightmap_uv(scene_of(mesh))[0];
    EXPECT_EQ(uv.overlapping.triangle, (std::vector<std::uint32_t>{4, 5}));
    EXPECT_TRUE(uv.is_lightmap());
}

TEST(LightmapUv, AreExaminedInTimeWhereAllTrianglesAreInOnePlace) {
    // A brick texture, repeated 20,000 times: comparing each with each would keep 2e8 pairs.
    Mesh mesh;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
        const float x = 2 * static_cast<float>(i);
        for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}) {
            mesh.position.emplace_back(x + corner.x, corner.y, 0.0f);
            mesh.texcoord[1].push_back(corner);
        }
        mesh.triangle.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const LightmapUv uv = shlm::find_lightmap_uv(scene_of(mesh))[0];
    EXPECT_NEAR(uv.overlapping_area, uv.area, 1e-3 * uv.area);
    EXPECT_FALSE(uv.is_lightmap());
}

/// Expects the texels of a scene, placed automatically for each triangle, to cover its whole surface.
void expect_texels_everywhere(const Scene& scene) {
    const auto uv = shlm::find_lightmap_uv(scene);
    const TexelLayout layout(scene, shlm::texel_charts(scene, uv, shlm::TexelPlacement::automatic, 1000),
                             1000);
    const auto geometry = shlm::texel_geometry(scene, layout, common::SurfacePieces(scene));
    double area = 0;
    for (const common::MeshInstance& instance : scene.instance) area += surface_area(scene, instance);
    EXPECT_NEAR(area_of(geometry), area, 1e-5 * area);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) EXPECT_GT(layout.triangle(t).width, 0u) << t;
}

TEST(TexelLayout, UselessCoordinatesHaveTexelsByFace) {
    Mesh mesh = with_lightmap_uv(quad({0, 0, 0}, {1, 0, 0}, {0, 2, 0}), left_half);
    mesh = joined(mesh, with_lightmap_uv(quad({5, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                         std::vector<Vec2>(4, Vec2(0.7f, 0.5f))));
    mesh = joined(mesh, with_lightmap_uv(quad({9, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}), left_half));
    const Scene scene = scene_of(mesh);
    expect_texels_everywhere(scene);
    const auto uv = shlm::find_lightmap_uv(scene);
    EXPECT_TRUE(shlm::placed_by_uv(uv[0], shlm::TexelPlacement::automatic));
    const auto lines = shlm::describe_useless_uv(scene, uv);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("1.25 m^2"), std::string::npos) << lines[0];
}

TEST(LightmapUv, MeasuresAreaAndCoverage) {
    const std::vector<Vec2> corner = {{0.75f, 0.75f}, {1, 0.75f}, {1, 1}, {0.75f, 1}};
    const LightmapUv uv = shlm::find_lightmap_uv(two_quads(left_half, corner))[0];
    EXPECT_EQ(uv.texcoord_set, 1);
    EXPECT_NEAR(uv.area, 4, 1e-5);
    EXPECT_NEAR(uv.covered_fraction, 0.5 + 1.0 / 16, 0.01);
    EXPECT_EQ(uv.bounds.min, Vec2(0, 0));
    EXPECT_EQ(uv.bounds.max, Vec2(1, 1));
}

Scene with_texcoord_0_only(std::vector<Vec2> uv) {
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.texcoord[0] = std::move(uv);
    mesh.texcoord[1].clear();
    return scene_of(mesh);
}

TEST(LightmapUv, UsesTexcoord0OnlyWhereItIsValid) {
    EXPECT_EQ(shlm::find_lightmap_uv(with_texcoord_0_only({{0, 0}, {1, 0}, {1, 1}, {0, 1}}))[0].texcoord_set,
              0);
    EXPECT_EQ(shlm::find_lightmap_uv(with_texcoord_0_only({{0, 0}, {4, 0}, {4, 4}, {0, 4}}))[0].texcoord_set,
              -1)
        << "repeating texture";
    EXPECT_EQ(
        shlm::find_lightmap_uv(with_texcoord_0_only({{0, 0}, {1, 0}, {1, 1}, {1, 0.1f}}))[0].texcoord_set, -1)
        << "folded over";
    EXPECT_EQ(shlm::find_lightmap_uv(with_texcoord_0_only({{0, 0}, {1, 0}, {1, 0}, {0, 0}}))[0].texcoord_set,
              -1)
        << "a line";
    EXPECT_EQ(shlm::find_lightmap_uv(with_texcoord_0_only({}))[0].texcoord_set, -1);
    const Scene none = with_texcoord_0_only({});
    EXPECT_EQ(shlm::describe_lightmap_trouble(none, shlm::find_lightmap_uv(none)).size(), 1u);
}

TEST(LightmapUv, TakesTexcoord1AsItIs) {
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.texcoord[1] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const Scene scene = scene_of(mesh);
    EXPECT_EQ(shlm::find_lightmap_uv(scene)[0].texcoord_set, 1);
    EXPECT_TRUE(shlm::describe_lightmap_trouble(scene, shlm::find_lightmap_uv(scene)).empty());
}

TEST(LightmapUv, LeavesMirrorsAndGlassAlone) {
    Scene scene = closed_box(mirror());
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), glass());
    const std::vector<LightmapUv> uv = shlm::find_lightmap_uv(scene);
    for (const LightmapUv& u : uv) EXPECT_EQ(u.texcoord_set, -1);
    EXPECT_TRUE(shlm::describe_lightmap_trouble(scene, uv).empty());
}

}  // namespace
