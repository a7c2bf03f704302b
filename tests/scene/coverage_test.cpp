// Tests the coverage of surfaces by their alpha.
#include "common/scene/coverage.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/see_through.h"

namespace {

using namespace tests;
using common::AlphaMode;
using common::coverage_at;
using common::coverage_range;

Scene plate(const Material& material) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
    return scene;
}

float coverage(const Material& material) {
    return coverage_at(plate(material), {0, 0.3f, 0.4f});
}

TEST(Coverage, IsWhatTheAlphaModeMakesOfAlpha) {
    Material material = diffuse(Rgb(1, 1, 1));
    material.alpha = 0.3f;
    EXPECT_EQ(coverage(material), 1) << "opaque whatever alpha says";
    EXPECT_EQ(coverage(blended(material, 0.3f)), 0.3f);
    EXPECT_EQ(coverage(blended(material, 0)), 0);
    EXPECT_EQ(coverage(masked(material, 0.49f)), 0);
    EXPECT_EQ(coverage(masked(material, 0.5f)), 1) << "at the cutoff it is there";
    Material strict = masked(material, 1);
    strict.alpha_cutoff = 1.5f;
    EXPECT_EQ(coverage(strict), 0) << "no alpha reaches such a cutoff";
    strict = masked(material, 0);
    strict.alpha_cutoff = 0;
    EXPECT_EQ(coverage(strict), 1) << "every alpha reaches such a cutoff";
}

TEST(Coverage, MultipliesFactorTextureAndVertices) {
    Scene scene;
    scene.texture.emplace_back("a quarter", 1, 1, std::vector<std::uint8_t>(3, 255), common::ColorSpace::srgb,
                               common::Wrap::repeat, common::Wrap::repeat, std::vector<std::uint8_t>{51});
    Material material = blended(diffuse(Rgb(1, 1, 1)), 0.5f);
    material.base_color_texture.texture = 0;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
    EXPECT_NEAR(coverage_at(scene, {0, 0.3f, 0.4f}), 0.5f * 0.2f, 1e-6f);
    scene.color.assign(4, Rgb(1, 1, 1));
    scene.alpha = {1, 0.5f, 0, 1};
    EXPECT_NEAR(coverage_at(scene, {0, 0.5f, 0.25f}), 0.5f * 0.2f * (1 - 0.25f - 0.25f), 1e-6f);
    EXPECT_EQ(scene.texture[0].sample({0.5f, 0.5f}), Rgb(1, 1, 1)) << "alpha is no part of the colour";
}

// Filtering rounds: an alpha of 1 everywhere must not fall below a cutoff of 1 in places.
TEST(Coverage, HasNoPinholesWhereAlphaIsTheCutoff) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const auto& [byte, cutoff] : {std::pair(255, 1.0f), std::pair(51, 0.2f), std::pair(102, 0.4f)}) {
        Scene scene;
        const auto value = static_cast<std::uint8_t>(byte);
        scene.texture.emplace_back("even", 3, 3, std::vector<std::uint8_t>(27, 255), common::ColorSpace::srgb,
                                   common::Wrap::repeat, common::Wrap::repeat,
                                   std::vector<std::uint8_t>(9, value));
        Material material = masked(diffuse(Rgb(1, 1, 1)));
        material.base_color_texture.texture = 0;
        material.alpha_cutoff = cutoff;
        add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
        for (int i = 0; i < 10'000; ++i) {
            const float u = uniform(engine), v = uniform(engine) * (1 - u);
            ASSERT_EQ(coverage_at(scene, {0, u, v}), 1) << byte << ", " << u << ", " << v;
        }
    }
}

TEST(Coverage, RangeHoldsAllOfATriangle) {
    const Scene scene = see_through_room();
    std::mt19937 engine(2);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        const common::CoverageRange range = coverage_range(scene, t);
        const bool whole = scene.material_of(t).alpha_mode == AlphaMode::opaque;
        EXPECT_EQ(range.has_holes(), !whole);
        for (int i = 0; i < 100; ++i) {
            const float u = uniform(engine), v = uniform(engine) * (1 - u);
            const float at = coverage_at(scene, {t, u, v});
            EXPECT_GE(at, range.least - 1e-6f);
            EXPECT_LE(at, range.most + 1e-6f);
        }
    }
}

TEST(Coverage, OfWhatNeedsNoHolesIsWhole) {
    const Material material = diffuse(Rgb(1, 1, 1));
    EXPECT_FALSE(coverage_range(plate(blended(material, 1)), 0).has_holes()) << "BLEND with alpha 1";
    EXPECT_FALSE(coverage_range(plate(masked(material, 0.6f)), 0).has_holes());
    EXPECT_TRUE(coverage_range(plate(blended(material, 0.99f)), 0).has_holes());
    EXPECT_FALSE(coverage_range(plate(blended(material, 0.01f)), 0).is_nowhere());
    EXPECT_TRUE(coverage_range(plate(blended(material, 0)), 0).is_nowhere());
    EXPECT_TRUE(coverage_range(plate(masked(material, 0.4f)), 0).is_nowhere());
}

}  // namespace
