// Tests that the project's own scenes match bench/scenes/README.md: lit, closed, and with usable lightmap
// coordinates.
#include <gtest/gtest.h>

#include "common/gltf/load_gltf.h"
#include "common/tracer/null_sink.h"
#include "common/tracer/trace_photons.h"
#include "shlm/layout/lightmap_uv.h"
#include "tests/support/child_process.h"
#include "tests/support/gltf_text.h"

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

// Random rooms are as closed as the others, equal for equal seeds, and different for different seeds.

class RandomRoom : public testing::Test {
  protected:
    [[nodiscard]] child_process::Ended make(const std::string& folder, const std::string& name) const {
        std::filesystem::create_directories(path(folder));
        return child_process::Child(SHLMBENCH_BINARY_DIR "/shlmbench_scenes", {path(folder), name},
                                    directory_.path())
            .wait();
    }
    [[nodiscard]] std::string made(const std::string& folder, const std::string& name) const {
        EXPECT_EQ(make(folder, name).exit_code, 0);
        return child_process::text_of(path(folder) + "/" + name + ".glb");
    }
    [[nodiscard]] std::string path(const std::string& name) const {
        return (directory_.path() / name).string();
    }

  private:
    gltf_text::TemporaryDirectory directory_;
};

TEST_F(RandomRoom, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const std::string first = made("a", "room-17");
    EXPECT_GT(first.size(), 1000u);
    EXPECT_EQ(first, made("b", "room-17"));
    EXPECT_NE(first, made("a", "room-18"));
}

TEST_F(RandomRoom, IsClosedAndLit) {
    for (const char* name : {"room-1", "room-2", "room-3"}) {
        SCOPED_TRACE(name);
        ASSERT_EQ(make("rooms", name).exit_code, 0);
        const common::Scene scene = common::load_gltf(path("rooms") + "/" + name + ".glb");
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        EXPECT_EQ(scene.camera.size(), 1u);
        EXPECT_TRUE(shlm::describe_lightmap_trouble(scene, shlm::find_lightmap_uv(scene)).empty());
        const common::RayScene rays(scene);
        common::NullSink sink;
        const auto report =
            common::trace_photons(rays, common::PhotonSource(scene), 1, {.photons = 50'000}, sink);
        EXPECT_GT(report.hits, 50'000u);
        EXPECT_LE(report.fates.escaped, 1u) << "one ray in a million may slip past an edge";
    }
}

TEST_F(RandomRoom, RefusesNamesThatAreNoSeed) {
    for (const char* name : {"room-", "room-x", "room--1", "room-01", "room-4294967296", "rooms-1"}) {
        const auto ended = make("none", name);
        EXPECT_EQ(ended.exit_code, 2) << name;
        EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
    }
    EXPECT_TRUE(std::filesystem::is_empty(path("none")));
}

}  // namespace
