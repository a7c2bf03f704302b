// The project's own scenes are what bench/scenes/README.md says: lit, closed, and with lightmap coordinates
// that serve.
#include <gtest/gtest.h>

#include "common/gltf/load_gltf.h"
#include "common/tracer/null_sink.h"
#include "common/tracer/trace_photons.h"
#include "shlm/layout/lightmap_uv.h"

namespace {

struct Expected {
    const char* name;
    std::size_t least_triangles, emitting_materials, point_lights, spot_lights, textures;
};

std::ostream& operator<<(std::ostream& out, const Expected& expected) {
    return out << expected.name;
}

class OwnScene : public testing::TestWithParam<Expected> {
  protected:
    const common::Scene scene =
        common::load_gltf(std::string(SHLMBENCH_BINARY_DIR "/scenes/") + GetParam().name + ".glb");
};

TEST_P(OwnScene, HasWhatItIsMadeFor) {
    const auto emits = [](const common::Material& material) { return material.emits(); };
    EXPECT_GE(scene.triangle.size(), GetParam().least_triangles);
    EXPECT_EQ(std::count_if(scene.material.begin(), scene.material.end(), emits),
              GetParam().emitting_materials);
    EXPECT_EQ(scene.point_light.size(), GetParam().point_lights);
    EXPECT_EQ(scene.spot_light.size(), GetParam().spot_lights);
    EXPECT_GE(scene.texture.size(), GetParam().textures);
    EXPECT_GE(scene.camera.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
}

TEST_P(OwnScene, HasLightmapCoordinatesThatDoNotOverlap) {
    const auto uv = shlm::find_lightmap_uv(scene);
    for (std::size_t i = 0; i < uv.size(); ++i) {
        if (scene.material[scene.instance[i].material].kind != common::SurfaceKind::diffuse) continue;
        EXPECT_EQ(uv[i].texcoord_set, 1) << scene.instance[i].name;
        EXPECT_EQ(uv[i].overlapping_area, 0) << scene.instance[i].name;
        EXPECT_GT(uv[i].covered_fraction, 0.6) << scene.instance[i].name;
    }
    EXPECT_TRUE(shlm::describe_lightmap_trouble(scene, uv).empty());
}

TEST_P(OwnScene, LosesNoPhotons) {
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    common::NullSink sink;
    const auto report = common::trace_photons(rays, source, 1, {.photons = 50'000}, sink);
    EXPECT_EQ(report.fates.missed, 0u);
    EXPECT_LE(report.fates.escaped, 1u) << "one ray in a million may slip past an edge";
}

INSTANTIATE_TEST_SUITE_P(Scenes, OwnScene,
                         testing::Values(Expected{"cornell", 40, 1, 0, 0, 0},
                                         Expected{"bumpy", 100, 1, 0, 1, 1},
                                         Expected{"caustic", 2'000, 1, 0, 0, 0},
                                         Expected{"atrium", 200'000, 1, 8, 1, 1}),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
