#include "common/tracer/photon_surfaces.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/scene_builder.h"

namespace {

using namespace tests;

/// A photon whose color differs in its last bit may end elsewhere, so whoever follows photons by way of the
/// scene must get what the tracer gets.
TEST(PhotonSurfaces, RoundAsTheSceneDoes) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(0, 1), anywhere(-20, 20);
    const auto place = [&] { return Vec3(anywhere(engine), anywhere(engine), anywhere(engine)); };
    Scene scene;
    scene.texture.emplace_back("grey", 1, 1, std::vector<std::uint8_t>(3, 128), common::ColorSpace::linear,
                               common::Wrap::repeat, common::Wrap::repeat);
    Material textured = diffuse(Rgb(1, 1, 1));
    textured.base_color_texture.texture = 0;
    for (int i = 0; i < 100; ++i) {
        Mesh mesh = quad(place(), place(), place());
        for (Vec2& uv : mesh.texcoord[0]) uv = {anywhere(engine), anywhere(engine)};
        if (i % 2 == 1)
            textured.base_color_texture.transform = {Vec2(anywhere(engine), anywhere(engine)),
                                                     Vec2(anywhere(engine), anywhere(engine)),
                                                     Vec2(anywhere(engine), anywhere(engine))};
        add(scene, mesh, textured);
    }
    const common::PhotonSurfaces surfaces(scene);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        for (int i = 0; i < 20; ++i) {
            const float u = uniform(engine), v = uniform(engine) * (1 - u);
            EXPECT_EQ(surfaces[t].position(u, v), common::position_at(scene, {t, u, v}));
            const common::TextureUse& use = scene.material_of(t).base_color_texture;
            EXPECT_EQ(surfaces.texture(t).texcoord(u, v), common::texcoord_at(scene, {t, u, v}, use));
            if (t < 2) {
                EXPECT_EQ(surfaces.texture(t).texcoord(u, v), common::texcoord_at(scene, {t, u, v}, 0));
            }
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

}  // namespace
