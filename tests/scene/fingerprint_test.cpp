#include "common/scene/fingerprint.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/support/scene_builder.h"

namespace {

using namespace tests;

Scene some_scene() {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.texture.emplace_back("grey", 1, 1, std::vector<std::uint8_t>{1, 2, 3}, common::ColorSpace::srgb,
                               common::Wrap::repeat, common::Wrap::repeat);
    scene.point_light.push_back({{0, 0, 0}, Rgb(1, 1, 1)});
    scene.spot_light.push_back({{0, 0, 0}, {0, 1, 0}, Rgb(1, 1, 1), 0.9f, 0.8f});
    scene.directional_light.push_back({{0, 1, 0}, Rgb(1, 1, 1)});
    return scene;
}

TEST(Fingerprint, IsSixteenHexadecimalDigits) {
    const std::string text = common::fingerprint(some_scene());
    EXPECT_EQ(text.size(), 16u);
    EXPECT_EQ(text.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(common::fingerprint(some_scene()), text);
}

TEST(Fingerprint, KnowsEverythingThatLightDependsOn) {
    using common::ColorSpace;
    using common::Wrap;
    const auto texture = [](std::uint8_t blue, ColorSpace color_space, Wrap wrap) {
        return common::Texture("grey", 1, 1, {1, 2, blue}, color_space, Wrap::repeat, wrap);
    };
    const std::vector<std::function<void(Scene&)>> changes = {
        [](Scene&) {},
        [](Scene& s) { s.position[3].y += 0.001f; },
        [](Scene& s) { s.normal[3].y += 0.001f; },
        [](Scene& s) { s.texcoord[0][3].y += 0.001f; },
        [](Scene& s) { s.texcoord[1][3].y += 0.001f; },
        [](Scene& s) { s.tangent[3].y += 0.001f; },
        [](Scene& s) { s.tangent_sign[3] = -1; },
        [](Scene& s) { std::swap(s.triangle[0], s.triangle[1]); },
        [](Scene& s) { s.instance[0].material = 1; },
        [](Scene& s) { s.material[0].kind = common::SurfaceKind::mirror; },
        [](Scene& s) { s.material[0].base_color.z = 0.6f; },
        [](Scene& s) { s.material[0].base_color_texture.texture = 0; },
        [](Scene& s) { s.material[0].normal_texture.texture = 0; },
        [](Scene& s) { s.material[0].normal_scale = 2; },
        [](Scene& s) { s.material[0].emitted_radiance.x = 1; },
        [](Scene& s) { s.material[0].emissive_texture.texture = 0; },
        [](Scene& s) { s.material[0].index_of_refraction = 1.6f; },
        [](Scene& s) { s.material[0].double_sided = true; },
        [](Scene& s) { s.material[0].alpha_mode = common::AlphaMode::mask; },
        [](Scene& s) { s.material[0].alpha_mode = common::AlphaMode::blend; },
        [](Scene& s) {
            s.material[0].alpha_mode = common::AlphaMode::blend;
            s.material[0].alpha = 0.5f;
        },
        [](Scene& s) {
            s.material[0].alpha_mode = common::AlphaMode::mask;
            s.material[0].alpha_cutoff = 0.4f;
        },
        [](Scene& s) { s.material[0].base_color_texture.transform.offset.x = 0.5f; },
        [](Scene& s) { s.material[0].base_color_texture.transform.along_u.x = 2; },
        [](Scene& s) { s.color.assign(s.position.size(), common::Rgb(0.5f, 1, 1)); },
        [](Scene& s) { s.origin.x = 1000; },
        [&](Scene& s) { s.texture[0] = texture(4, ColorSpace::srgb, Wrap::repeat); },
        [&](Scene& s) { s.texture[0] = texture(3, ColorSpace::linear, Wrap::repeat); },
        [&](Scene& s) { s.texture[0] = texture(3, ColorSpace::srgb, Wrap::clamp_to_edge); },
        [](Scene& s) {
            s.texture[0] = common::Texture("grey", 1, 1, {1, 2, 3}, ColorSpace::srgb, Wrap::repeat,
                                           Wrap::repeat, {}, common::Filter::nearest);
        },
        [](Scene& s) {
            s.texture[0] = common::Texture("grey", 1, 1, {1, 2, 3}, ColorSpace::linear, Wrap::repeat,
                                           Wrap::repeat, {}, common::Filter::linear, {300, 500, 700});
        },
        [](Scene& s) { s.point_light[0].position.x = 1; },
        [](Scene& s) { s.point_light[0].intensity.x = 2; },
        [](Scene& s) { s.point_light.push_back(s.point_light[0]); },
        [](Scene& s) { s.spot_light[0].axis.x = 1; },
        [](Scene& s) { s.spot_light[0].cos_inner_angle = 0.95f; },
        [](Scene& s) { s.spot_light[0].cos_outer_angle = 0.7f; },
        [](Scene& s) { s.spot_light[0].cos_inner_angle = s.spot_light[0].cos_outer_angle = 1 - 1e-9; },
        [](Scene& s) { s.spot_light[0].cos_inner_angle = s.spot_light[0].cos_outer_angle = 1 - 2e-9; },
        [](Scene& s) { s.directional_light[0].direction.x = 1; },
        [](Scene& s) { s.directional_light[0].irradiance.x = 2; },
        [](Scene& s) { s.sky = common::Sky{Rgb(1, 0, 0)}; },
    };
    std::set<std::string> seen;
    for (const auto& change : changes) {
        Scene scene = some_scene();
        change(scene);
        seen.insert(common::fingerprint(scene));
    }
    EXPECT_EQ(seen.size(), changes.size());
}

TEST(Fingerprint, ForgetsNamesAndCameras) {
    Scene scene = some_scene();
    scene.source = "elsewhere.glb";
    scene.material[0].name = "other";
    scene.instance[0].name = "other";
    scene.point_light[0].name = "other";
    scene.camera.emplace_back();
    EXPECT_EQ(common::fingerprint(scene), common::fingerprint(some_scene()));
}

}  // namespace
