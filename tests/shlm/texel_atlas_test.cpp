// Where texels go in a picture.
#include "shlm/file/texel_atlas.h"

#include <gtest/gtest.h>

#include <set>

#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/prepared_texels.h"
#include "tests/support/scene_builder.h"

namespace {

using namespace tests;

Scene box_with_a_cloth() {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    add(scene, quad({-0.5f, 0, 0}, {1, 0, 0}, {0, 0.7f, 0}), double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f))));
    return scene;
}

TEST(TexelAtlas, GivesEachTexelAPixelOfItsOwnWithFreePixelsAround) {
    const Scene scene = box_with_a_cloth();
    const std::vector<shlm::LightmapUv> uv = shlm::find_lightmap_uv(scene);
    const shlm::PreparedTexels texels(scene, uv, 3000);
    for (const std::uint32_t gutter : {0u, 1u, 3u}) {
        SCOPED_TRACE(gutter);
        const shlm::TexelAtlas atlas(texels.layout, gutter);
        std::vector<std::size_t> rectangle_of(std::size_t{atlas.width()} * atlas.height(), 0);
        std::size_t number = 0, backs = 0;
        for (const shlm::TexelAtlas::Rectangle& r : atlas.rectangles()) {
            ++number;
            EXPECT_EQ(atlas.rectangle(r.first_texel).left, r.left);
            ASSERT_GE(r.left, gutter);
            ASSERT_GE(r.top, gutter);
            ASSERT_LE(r.left + r.width + gutter, atlas.width());
            ASSERT_LE(r.top + r.height + gutter, atlas.height());
            for (std::uint32_t y = r.top - gutter; y < r.top + r.height + gutter; ++y)
                for (std::uint32_t x = r.left - gutter; x < r.left + r.width + gutter; ++x) {
                    std::size_t& here = rectangle_of[std::size_t{y} * atlas.width() + x];
                    ASSERT_EQ(here, 0u) << "two rectangles, or their gutters, meet";
                    here = number;
                }
        }
        for (const shlm::TexelRegion& region : texels.layout.regions()) backs += region.both_faces;
        EXPECT_EQ(number, texels.layout.regions().size() + backs);
        EXPECT_EQ(backs, 1u);

        std::set<std::size_t> pixels;
        std::vector<bool> seen(texels.layout.texel_count());
        atlas.for_each([&](std::size_t texel, std::size_t pixel) {
            EXPECT_FALSE(seen[texel]);
            seen[texel] = true;
            pixels.insert(pixel);
        });
        EXPECT_EQ(pixels.size(), texels.layout.texel_count());
    }
}

}  // namespace
