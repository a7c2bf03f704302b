// What an export hands on: pixels without holes, and coordinates of the texels that the program itself reads.
#include <gtest/gtest.h>

#include "bench/export/light_atlas.h"
#include "bench/export/lit_mesh.h"
#include "bench/export/viewer_page.h"
#include "shlm/basis/sh_basis.h"
#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/prepared_texels.h"
#include "tests/support/scene_builder.h"

namespace {

using namespace tests;
using shlm::no_texel;

/// A sphere, whose charts have uncovered texels, and a double-sided cloth.
Scene sphere_and_cloth() {
    Scene scene;
    add(scene, sphere({0, 0, 0}, 1, 3), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    add(scene, quad({-2, -2, -2}, {4, 0, 0}, {0, 4, 0}), double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f))));
    return scene;
}

struct Exported {
    Scene scene;
    shlm::PreparedTexels texels;
    bench::LightAtlas atlas;
};

Exported exported(shlm::TexelPlacement placement) {
    Scene scene = sphere_and_cloth();
    shlm::PreparedTexels texels(scene, shlm::find_lightmap_uv(scene), 2000, placement);
    std::vector<shlm::TexelFace> face;
    for (const shlm::TexelGeometry& texel : texels.geometry) face.push_back({texel.normal, texel.area});
    bench::LightAtlas atlas = bench::make_light_atlas(texels.layout, face);
    return {std::move(scene), std::move(texels), std::move(atlas)};
}

TEST(LightAtlas, ShowsCoveredTexelsWhereTheyAreAndTheNearestAround) {
    const Exported made = exported(shlm::TexelPlacement::face);
    const bench::LightAtlas& atlas = made.atlas;
    std::size_t uncovered = 0;
    for (const shlm::TexelAtlas::Rectangle& r : atlas.places.rectangles()) {
        const auto shown = [&](std::uint32_t x, std::uint32_t y) {
            return atlas.shown[std::size_t{y} * atlas.places.width() + x];
        };
        std::size_t covered = 0;
        for (std::uint32_t i = 0; i < r.width * r.height; ++i)
            covered += made.texels.geometry[r.first_texel + i].area > 0;
        uncovered += r.width * r.height - covered;
        for (std::uint32_t y = r.top - 1; y <= r.top + r.height; ++y)
            for (std::uint32_t x = r.left - 1; x <= r.left + r.width; ++x) {
                const std::uint32_t texel = shown(x, y);
                if (covered == 0) {
                    EXPECT_EQ(texel, no_texel);
                    continue;
                }
                ASSERT_GE(texel, r.first_texel);
                ASSERT_LT(texel, r.first_texel + r.width * r.height);
                EXPECT_GT(made.texels.geometry[texel].area, 0) << "an uncovered texel has no light to show";
                const bool inside = x >= r.left && x < r.left + r.width && y >= r.top && y < r.top + r.height;
                const std::uint32_t own =
                    inside ? r.first_texel + (y - r.top) * r.width + (x - r.left) : no_texel;
                if (inside && made.texels.geometry[own].area > 0) {
                    EXPECT_EQ(texel, own);
                }
            }
    }
    EXPECT_GT(uncovered, 0u);
}

TEST(TexelLayout, ACoarserOneHasTheSamePlaces) {
    for (const auto placement : {shlm::TexelPlacement::face, shlm::TexelPlacement::automatic}) {
        const Exported made = exported(placement);
        const shlm::TexelLayout& fine = made.texels.layout;
        std::vector<std::uint32_t> joined;
        for (std::size_t r = 0; r < fine.regions().size(); ++r) joined.push_back(r % 2 == 0 ? 4 : 1);
        const shlm::TexelLayout coarse = fine.coarser(joined);
        const shlm::TexelPlaces before(fine), after(coarse);
        std::size_t texels = 0;
        for (const shlm::TexelRegion& region : coarse.regions()) {
            EXPECT_EQ(region.first_texel, texels);
            texels += region.texels_per_face() * (region.both_faces ? 2 : 1);
        }
        EXPECT_EQ(coarse.texel_count(), texels);
        for (std::uint32_t t = 0; t < made.scene.triangle.size(); ++t) {
            const common::SurfacePoint point = front_of(made.scene, {t, 0.3f, 0.2f});
            const auto a = before.find(point), b = after.find(point);
            ASSERT_TRUE(a && b);
            EXPECT_EQ(a->region, b->region);
            const auto by = static_cast<float>(joined[a->region]);
            EXPECT_NEAR(b->at.x, a->at.x / by, 2e-3);
            EXPECT_NEAR(b->at.y, a->at.y / by, 2e-3);
            EXPECT_EQ(after.region(*b).width,
                      (before.region(*a).width + joined[a->region] - 1) / joined[a->region]);
        }
    }
}

TEST(LitMesh, HasTheCoordinatesThatFinishedMapsFind) {
    for (const auto placement : {shlm::TexelPlacement::face, shlm::TexelPlacement::automatic}) {
        const Exported made = exported(placement);
        const shlm::TexelPlaces places(made.texels.layout);
        std::size_t triangles = 0, backs = 0;
        for (const bench::LitPrimitive& primitive :
             bench::lit_primitives(made.scene, made.texels.layout, made.atlas)) {
            ASSERT_TRUE(primitive.lit);
            backs += primitive.back;
            const common::MeshInstance& instance = made.scene.instance[primitive.instance];
            ASSERT_EQ(primitive.index.size(), 3 * instance.triangle_count);
            for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
                ++triangles;
                // The middle of the triangle, from its corners and from the map itself.
                common::Vec2 at(0, 0);
                common::Vec3 position(0, 0, 0), normal(0, 0, 0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t v = primitive.index[3 * i + k];
                    at += primitive.light_texcoord[v] / 3;
                    position += primitive.position[v] / 3;
                    normal += primitive.normal[v] / 3;
                    const Imath::V4f& rectangle = primitive.light_rectangle[v];
                    EXPECT_EQ(rectangle, primitive.light_rectangle[primitive.index[3 * i]]);
                }
                common::SurfacePoint point =
                    front_of(made.scene, {instance.first_triangle + i, 1.0f / 3, 1.0f / 3});
                point.front = !primitive.back;
                const auto place = places.find(point);
                ASSERT_TRUE(place);
                const Imath::V4f& rectangle = primitive.light_rectangle[primitive.index[3 * i]];
                EXPECT_NEAR(at.x * static_cast<float>(made.atlas.places.width()), rectangle.x + place->at.x,
                            2e-3);
                EXPECT_NEAR(at.y * static_cast<float>(made.atlas.places.height()), rectangle.y + place->at.y,
                            2e-3);
                EXPECT_EQ(rectangle.z, static_cast<float>(places.region(*place).width));
                EXPECT_LT((position - point.position).length(), 1e-5f);
                const auto [a, b, c] = std::array{primitive.index[3 * i], primitive.index[3 * i + 1],
                                                  primitive.index[3 * i + 2]};
                const common::Vec3 wound = (primitive.position[b] - primitive.position[a])
                                               .cross(primitive.position[c] - primitive.position[a]);
                EXPECT_GT(wound.dot(normal), 0) << "the front is where the normals point";
            }
        }
        EXPECT_EQ(backs, 1u);
        EXPECT_EQ(triangles, made.scene.triangle.size() + 2) << "the cloth's two once more";
    }
}

TEST(TexcoordUse, CountsDifferentCoordinatesOnce) {
    common::Material material;
    material.base_color_texture = {0, 0, {}};
    material.normal_texture = {1, 0, {}};
    material.emissive_texture = {2, 1, {}};
    bench::TexcoordUse use = bench::texcoord_use(material);
    EXPECT_EQ(use.set.size(), 2u);
    EXPECT_EQ(std::tuple(use.base_color, use.normal, use.emissive), std::tuple(0, 0, 1));
    material.normal_texture.transform.offset = {0.5f, 0};
    use = bench::texcoord_use(material);
    EXPECT_EQ(use.set.size(), 3u);
    EXPECT_EQ(std::tuple(use.base_color, use.normal, use.emissive), std::tuple(0, 1, 2));
    EXPECT_EQ(bench::texcoord_use({}).set.size(), 0u);
}

TEST(ViewerPage, GetsItsConstantsFromTheLibrary) {
    const std::string lines = bench::glsl_constants();
    for (const auto& [name, value] :
         {std::pair("C0", shlm::sh_constants::c0), std::pair("C44", shlm::sh_constants::c44)}) {
        const std::size_t at = lines.find(std::string("const float ") + name + " = ");
        ASSERT_NE(at, std::string::npos) << lines;
        EXPECT_EQ(std::stof(lines.substr(lines.find("= ", at) + 2)), value);
    }
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 11);
}

}  // namespace
