#include "common/tracer/photon_surfaces.h"

#include <gtest/gtest.h>

#include <random>

#include "common/scene/coverage.h"
#include "tests/support/see_through.h"

namespace {

using namespace tests;

/// A photon whose colour differs in its last bit may take another path. So code that follows photons by way
/// of the scene must get the same values as the tracer.
TEST(PhotonSurfaces, RoundAsTheSceneDoes) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(0, 1), anywhere(-20, 20);
    const auto place = [&] { return Vec3(anywhere(engine), anywhere(engine), anywhere(engine)); };
    Scene scene;
    scene.texture.emplace_back("grey", 1, 1, std::vector<std::uint8_t>(3, 128), common::ColorSpace::linear,
                               common::Wrap::repeat, common::Wrap::repeat);
    Material textured = diffuse(Rgb(1, 1, 1));
    // Rotated and translated, as by KHR_texture_transform.
    textured.base_color_texture = {0, 0, {{0.3f, -7}, {0.8f, 0.6f}, {-0.6f, 0.8f}}};
    for (int i = 0; i < 100; ++i) {
        Mesh mesh = quad(place(), place(), place());
        for (Vec2& uv : mesh.texcoord[0]) uv = {anywhere(engine), anywhere(engine)};
        if (i % 2 == 1)
            textured.base_color_texture.transform = {Vec2(anywhere(engine), anywhere(engine)),
                                                     Vec2(anywhere(engine), anywhere(engine)),
                                                     Vec2(anywhere(engine), anywhere(engine))};
        add(scene, mesh, textured);
    }
    for (std::uint32_t i = 0; i < scene.instance.size(); ++i)
        set_color(scene, i,
                  [&](const Vec3&) { return Rgb(uniform(engine), uniform(engine), uniform(engine)); });
    const common::PhotonSurfaces surfaces(scene);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        for (int i = 0; i < 20; ++i) {
            const float u = uniform(engine), v = uniform(engine) * (1 - u);
            EXPECT_EQ(surfaces[t].position(u, v), common::position_at(scene, {t, u, v}));
            const common::TextureUse& use = scene.material_of(t).base_color_texture;
            EXPECT_EQ(surfaces.texture(t).texcoord(u, v), common::texcoord_at(scene, {t, u, v}, use));
            const Vec2 texcoord = surfaces.texture(t).texcoord(u, v);
            const Rgb color = surfaces[t].base_color * surfaces.texture(t).texture->sample(texcoord) *
                              surfaces.colors(t).color(u, v);
            EXPECT_EQ(color, common::base_color_at(scene, {t, u, v}));
        }
}

TEST(PhotonSurfaces, ReadTheTextureWhereItIsMoved) {
    Scene scene;
    scene.texture.emplace_back("grey", 1, 1, std::vector<std::uint8_t>(3, 128), common::ColorSpace::linear,
                               common::Wrap::repeat, common::Wrap::repeat);
    Material textured = diffuse(Rgb(1, 1, 1));
    textured.base_color_texture = {0, 0, {{0.25f, 0.5f}, {0, -2}, {3, 0}}};
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.texcoord[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    add(scene, mesh, textured);
    const common::PhotonSurfaces surfaces(scene);
    EXPECT_EQ(surfaces.texture(0).texcoord(0, 0), Vec2(0.25f, 0.5f));
    EXPECT_EQ(surfaces.texture(0).texcoord(1, 0), Vec2(0.25f, -1.5f));
    EXPECT_EQ(surfaces.texture(0).texcoord(0, 1), Vec2(3.25f, -1.5f));
}

TEST(PhotonSurfaces, KnowWhatEachTriangleTakes) {
    using common::PhotonSurface;
    Scene scene = see_through_room();
    const std::uint32_t plain = 1;
    scene.material[plain].alpha_mode = common::AlphaMode::blend;  // with an alpha of 1
    const auto add_plate = [&](const Material& material) {
        add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
        return static_cast<std::uint32_t>(scene.instance.size()) - 1;
    };
    const std::uint32_t masked_away = add_plate(masked(diffuse(Rgb(1, 1, 1)), 0.3f)),
                        textured = add_plate(checkered(scene, diffuse(Rgb(1, 1, 1)))),
                        colored_too = add_plate(checkered(scene, diffuse(Rgb(1, 1, 1))));
    set_color(scene, colored_too, [](const Vec3&) { return Rgb(0.5f, 1, 1); });
    const common::PhotonSurfaces surfaces(scene);
    for (const auto& [instance, kind] :
         {std::pair(+first_wall, PhotonSurface::colored_diffuse), std::pair(plain, PhotonSurface::diffuse),
          std::pair(+lamp, PhotonSurface::perforated_diffuse),
          std::pair(+fence, PhotonSurface::perforated_diffuse),
          std::pair(+veil, PhotonSurface::perforated_diffuse), std::pair(+pane, PhotonSurface::specular),
          std::pair(+colored_ball, PhotonSurface::colored_diffuse),
          std::pair(+blended_ball, PhotonSurface::perforated_diffuse),
          std::pair(masked_away, PhotonSurface::specular),
          std::pair(textured, PhotonSurface::textured_diffuse),
          std::pair(colored_too, PhotonSurface::textured_colored_diffuse)}) {
        const common::PhotonSurface& surface = surfaces[scene.instance[instance].first_triangle];
        EXPECT_EQ(surface.kind, kind) << "instance " << instance;
        EXPECT_EQ(surface.stores(), kind != PhotonSurface::specular);
    }
}

}  // namespace
