// Tests scenes that are far from the origin, such as buildings in map coordinates.
#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;
using Imath::V3d;

using LoadGltfFar = LoadGltf;

/// Makes a triangle of 1 m whose node is at `place`, with a lamp on the same node and a camera beside it.
GltfFile triangle_at(const std::array<double, 3>& place) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    file.node()["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.node()["translation"] = place;
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    file.document["nodes"].push_back(
        {{"camera", 0}, {"translation", {place[0] + 0.25, place[1] + 0.5, place[2] + 3}}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    return file;
}

TEST_F(LoadGltfFar, IsMovedNearItsOrigin) {
    // At the last place, floats cannot resolve metres.
    for (const std::array<double, 3> place :
         {std::array{500'000.3, 0.0, -5'600'000.7}, std::array{0.0, 12'345.6, 0.0},
          std::array{3e9 + 0.3, -7e9, 1e9}}) {
        const Scene scene = load(triangle_at(place));
        EXPECT_NE(scene.origin, V3d(0));
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        const V3d at(place[0], place[1], place[2]);
        const double digits = 5e-15 * at.length();  // of doubles, and of floats that cannot hold metres
        ASSERT_EQ(scene.triangle.size(), 1u);
        const std::array<V3d, 3> local = {V3d(0, 0, 0), V3d(1, 0, 0), V3d(0, 1, 0)};
        for (std::size_t i = 0; i < 3; ++i) {
            const V3d corner = scene.origin + V3d(triangles_of(scene)[0][i]);
            EXPECT_LT((corner - at - local[i]).length(), 1e-6 + digits) << corner;
        }
        EXPECT_LT((scene.origin + V3d(scene.point_light[0].position) - at).length(), 1e-6 + digits);
        EXPECT_LT((scene.origin + V3d(scene.camera[0].eye) - at - V3d(0.25, 0.5, 3)).length(), 1e-6 + digits);
        EXPECT_LT(scene.bounds.max.length(), 256 * scene.diagonal());
        // No property of a triangle may depend on its position.
        EXPECT_EQ(scene.geometric_normal[0], Vec3(0, 0, 1));
    }
}

TEST_F(LoadGltfFar, StaysWhereItIsWithin256Diagonals) {
    // The diagonal is 1.41 m, so distances up to 362 m count as near.
    const Scene near = load(triangle_at({360, 0, 0})), far = load(triangle_at({364, 0, 0}));
    EXPECT_EQ(near.origin, V3d(0));
    EXPECT_EQ(triangles_of(near)[0][0], Vec3(360, 0, 0));
    EXPECT_NE(far.origin, V3d(0));
    EXPECT_EQ(far.origin.x, std::round(far.origin.x)) << "a round number";
}

TEST_F(LoadGltfFar, PositionsMayBeFarThemselves) {
    // Map coordinates in the vertex buffer, where floats resolve half metres.
    GltfFile file = one_triangle();
    const std::vector<float> position = {500'000,    0,       -5'600'000, 500'010,      0,
                                         -5'600'000, 500'000, 10,         -5'600'000.5f};
    std::memcpy(file.buffer.data(), position.data(), position.size() * sizeof(float));
    const Scene scene = load(file);
    EXPECT_NE(scene.origin, V3d(0));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(scene.origin + V3d(triangles_of(scene)[0][i]),
                  V3d(position[3 * i], position[3 * i + 1], position[3 * i + 2]));
}

TEST_F(LoadGltfFar, NodesTakeLargePositionsBack) {
    GltfFile file = one_triangle();
    const std::vector<float> position = {4e6f, 0, 0, 4e6f + 1, 0, 0, 4e6f, 1, 0};
    std::memcpy(file.buffer.data(), position.data(), position.size() * sizeof(float));
    file.node()["translation"] = {-4e6, 0, 0};
    const Scene scene = load(file);
    EXPECT_EQ(scene.origin, V3d(0));
    EXPECT_EQ(triangles_of(scene)[0][1], Vec3(1, 0, 0));
}

TEST_F(LoadGltfFar, WarnsWhereFloatsCannotHoldBothEnds) {
    GltfFile file = one_triangle();
    file.node()["name"] = "here";
    file.document["nodes"].push_back({{"mesh", 0}, {"name", "there"}, {"translation", {5.6e6, 0, 0}}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(file);
    EXPECT_EQ(scene.origin, V3d(0)) << "it is as large as it is far";
    EXPECT_TRUE(has_warning(scene, "floats blur it: there"));
    EXPECT_FALSE(has_warning(scene, "here and"));

    file.node(1)["translation"] = {100, 0, 0};
    EXPECT_TRUE(load(file).warnings.empty());
}

TEST_F(LoadGltfFar, SaysWhatItSaysAnywhereButOnce) {
    GltfFile file = triangle_at({1e6, 0, 0});
    file.primitive()["targets"] = {{{"POSITION", 0}}};
    const Scene scene = load(file);
    EXPECT_FALSE(has_warning(scene, "more"));
}

}  // namespace
