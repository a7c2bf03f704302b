// glTF loader: morph targets and skins in the pose without animation.
#include <numbers>

#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

using LoadGltfMorphTargets = LoadGltf;
using LoadGltfSkins = LoadGltf;

// ---- Morph targets ----

/// Makes one triangle with normals and two targets: the first lifts it by 1, the second moves it to the right
/// by 2 and inverts its normals.
GltfFile morphed_triangle() {
    GltfFile file = one_triangle();
    const int up = file.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, "VEC3");
    const int right = file.add_accessor<float>({2, 0, 0, 2, 0, 0, 2, 0, 0}, f32, "VEC3");
    const int over = file.add_accessor<float>({1, 0, -1, 1, 0, -1, 1, 0, -1}, f32, "VEC3");
    file.primitive()["attributes"]["NORMAL"] = up;
    file.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", right}, {"NORMAL", over}}};
    return file;
}

TEST_F(LoadGltfMorphTargets, HaveTheMeshsWeights) {
    GltfFile file = morphed_triangle();
    file.document["meshes"][0]["weights"] = {0.5, 1};
    const Scene scene = load(file);
    EXPECT_EQ(triangles_of(scene)[0],
              (std::array<Vec3, 3>{Vec3(2, 0, 0.5f), Vec3(3, 0, 0.5f), Vec3(2, 1, 0.5f)}));
    EXPECT_EQ(scene.normal[0], Vec3(1, 0, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfMorphTargets, HaveTheNodesWeightsWhereThereAreSome) {
    GltfFile file = morphed_triangle();
    file.document["meshes"][0]["weights"] = {0.5, 1};
    file.node()["weights"] = {-3, 0};
    file.document["nodes"].push_back({{"mesh", 0}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(file);
    EXPECT_EQ(triangles_of(scene)[0][0], Vec3(0, 0, -3));
    EXPECT_EQ(triangles_of(scene)[1][0], Vec3(2, 0, 0.5f));
}

TEST_F(LoadGltfMorphTargets, DoNothingWithoutWeights) {
    const Scene scene = load(morphed_triangle());
    EXPECT_EQ(triangles_of(scene), triangles_of(load(one_triangle())));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfMorphTargets, MoveOnlyTheVerticesOfTheirTriangles) {
    GltfFile file = morphed_triangle();
    file.document["meshes"][0]["weights"] = {1, 0};
    file.primitive()["attributes"]["POSITION"] =
        file.add_accessor<float>({nan_value, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, f32, "VEC3");
    file.primitive()["attributes"].erase("NORMAL");
    file.primitive()["targets"] = {
        {{"POSITION", file.add_accessor<float>({9, 9, 9, 0, 0, 2, 0, 0, 3, 0, 0, 4}, f32, "VEC3")}}};
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({2, 3, 1}, u8, "SCALAR");
    EXPECT_EQ(triangles_of(load(file))[0],
              (std::array<Vec3, 3>{Vec3(0, 0, 3), Vec3(1, 0, 4), Vec3(0, 1, 2)}));
}

TEST_F(LoadGltfMorphTargets, CanBeSparseAndNormalized) {
    GltfFile file = morphed_triangle();
    const int places = file.add_view(bytes_of<std::uint8_t>({1}));
    const int values = file.add_view(bytes_of<float>({0, 0, 7}));
    file.document["accessors"].push_back({{"componentType", f32},
                                          {"count", 3},
                                          {"type", "VEC3"},
                                          {"sparse",
                                           {{"count", 1},
                                            {"indices", {{"bufferView", places}, {"componentType", u8}}},
                                            {"values", {{"bufferView", values}}}}}});
    const auto sparse = static_cast<int>(file.document["accessors"].size()) - 1;
    const int bytes =
        file.add_accessor<std::int16_t>({0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, -32767, 0}, i16, "VEC3");
    file.accessor(bytes).update({{"count", 3}, {"normalized", true}});
    file.view(file.accessor(bytes)["bufferView"])["byteStride"] = 8;
    file.primitive()["targets"] = {{{"POSITION", sparse}}, {{"POSITION", bytes}}};
    file.document["meshes"][0]["weights"] = {1, 2};
    EXPECT_EQ(triangles_of(load(file))[0],
              (std::array<Vec3, 3>{Vec3(0, 0, 2), Vec3(1, 0, 9), Vec3(0, 1, -2)}));
}

TEST_F(LoadGltfMorphTargets, MoveTangentsAndTextureCoordinates) {
    GltfFile file = morphed_triangle();
    const int along_x = file.add_accessor<float>({1, 0, 0, 1, 0, 0, 1, 0, 0}, f32, "VEC3");
    const int halves = file.add_accessor<float>({0.5f, 0, 0.5f, 0, 0.5f, 0}, f32, "VEC2");
    Json& attributes = file.primitive()["attributes"];
    attributes["TANGENT"] = file.add_accessor<float>({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, f32, "VEC4");
    attributes["TEXCOORD_0"] = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, f32, "VEC2");
    attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
    file.primitive()["targets"] = {{{"TANGENT", along_x}, {"TEXCOORD_1", halves}}};
    file.document["meshes"][0]["weights"] = {1};
    const Scene scene = load(file);
    expect_near(scene.tangent[0], Vec3(1, 1, 0).normalized());
    EXPECT_EQ(scene.tangent_sign[0], -1);
    EXPECT_EQ(scene.texcoord[0][0], Vec2(0, 0));
    EXPECT_EQ(scene.texcoord[1][0], Vec2(0.5f, 0));
}

TEST_F(LoadGltfMorphTargets, AreRefusedWithWrongIndicesTypesAndLengths) {
    GltfFile file = morphed_triangle();
    file.document["meshes"][0]["weights"] = {1, 1};
    const Json targets = file.primitive()["targets"];
    file.primitive()["targets"][0]["POSITION"] = 99;
    expect_error(file, "targets/0/POSITION is 99");
    file.primitive()["targets"] = {7};
    expect_error(file, "targets/0 is not an object");
    file.primitive()["targets"] = 7;
    expect_error(file, "targets is not a list");
    file.primitive()["targets"] = {{{"POSITION", file.add_accessor<float>({0, 0, 1, 0, 0, 1}, f32, "VEC3")}}};
    expect_error(file, "morph target has 2 elements");
    file.primitive()["targets"] = {{{"POSITION", file.add_accessor<float>({0, 0, 1, 0}, f32, "VEC2")}}};
    expect_error(file, "VEC3");
    file.primitive()["targets"] = targets;
    file.document["meshes"][0]["weights"] = {"much"};
    expect_error(file, "meshes/0/weights");
    file.document["meshes"][0]["weights"] = {1e30, 0};
    expect_error(file, "position");
}

TEST_F(LoadGltfMorphTargets, WarnOfWeightsThatHaveNone) {
    GltfFile file = morphed_triangle();
    file.document["meshes"][0]["weights"] = {0, 0, 1};
    EXPECT_TRUE(has_warning(load(file), "weights without a morph target"));
}

// ---- Skins ----

/// Makes one triangle whose corners follow joint 1, joint 2 and both. Joint 1 is moved up by 5; joint 2 is
/// rotated by 90 degrees about z. Both were bound one metre to the right of the origin. The mesh's own node
/// is far away.
GltfFile skinned_triangle() {
    GltfFile file = one_triangle();
    Json& attributes = file.primitive()["attributes"];
    attributes["NORMAL"] = file.add_accessor<float>({0, 1, 0, 0, 1, 0, 0, 1, 0}, f32, "VEC3");
    attributes["JOINTS_0"] =
        file.add_accessor<std::uint8_t>({0, 9, 9, 9, 1, 9, 9, 9, 0, 1, 9, 9}, u8, "VEC4");
    attributes["WEIGHTS_0"] =
        file.add_accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, f32, "VEC4");
    const std::vector<float> bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    std::vector<float> both = bind;
    both.insert(both.end(), bind.begin(), bind.end());
    const int matrices = file.add_accessor<float>(both, f32, "SCALAR");
    file.accessor(matrices).update({{"type", "MAT4"}, {"count", 2}});
    const double half = std::numbers::sqrt2 / 2;
    file.document["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
    file.document["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                              {{"translation", {1, 0, 5}}},
                              {{"translation", {1, 0, 0}}, {"rotation", {0, 0, half, half}}}};
    file.document["scenes"][0]["nodes"] = {0, 1, 2};
    return file;
}

TEST_F(LoadGltfSkins, AreInThePoseOfTheirJoints) {
    const Scene scene = load(skinned_triangle());
    ASSERT_EQ(scene.triangle.size(), 1u);
    expect_near(triangles_of(scene)[0][0], {0, 0, 5});
    expect_near(triangles_of(scene)[0][1], {1, 0, 0});
    // (0, 1, 0) becomes half of (0, 1, 5) and half of (0, -1, 0).
    expect_near(triangles_of(scene)[0][2], {0, 0, 2.5f});
    expect_near(scene.normal[0], {0, 1, 0});
    expect_near(scene.normal[1], {-1, 0, 0});
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfSkins, HaveJointsThatTheirBindPoseLeavesInPlace) {
    GltfFile file = skinned_triangle();
    file.document["skins"][0].erase("inverseBindMatrices");
    EXPECT_EQ(triangles_of(load(file))[0][0], Vec3(1, 0, 5)) << "identity where there are no matrices";
}

TEST_F(LoadGltfSkins, HaveMoreThanFourJointsAndWeightsOfAnySum) {
    GltfFile file = skinned_triangle();
    Json& attributes = file.primitive()["attributes"];
    attributes["JOINTS_1"] =
        file.add_accessor<std::uint16_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, u16, "VEC4");
    const int weights = file.add_accessor<std::uint8_t>({255, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0}, u8, "VEC4");
    file.accessor(weights)["normalized"] = true;
    attributes["WEIGHTS_1"] = weights;
    const Scene scene = load(file);
    expect_near(triangles_of(scene)[0][0], {0.5f, -0.5f, 2.5f});
    // It becomes a quarter of (0, 1, 5) and three quarters of (0, -1, 0).
    expect_near(triangles_of(scene)[0][2], {0, -0.5f, 1.25f});
}

TEST_F(LoadGltfSkins, AreMirroredWithTheirJoints) {
    GltfFile file = skinned_triangle();
    file.document["skins"][0] = {{"joints", {1, 1}}};
    file.document["nodes"][1] = {{"scale", {-1, 1, 1}}};
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, "VEC3");
    const Scene scene = load(file);
    expect_near(scene.geometric_normal[0], {0, 0, 1});
    expect_near(scene.normal[0], {0, 0, 1});
}

TEST_F(LoadGltfSkins, GoWithMorphTargets) {
    GltfFile file = skinned_triangle();
    file.primitive()["targets"] = {
        {{"POSITION", file.add_accessor<float>({1, 0, 0, 1, 0, 0, 1, 0, 0}, f32, "VEC3")}}};
    file.node()["weights"] = {2};
    const Scene scene = load(file);
    expect_near(triangles_of(scene)[0][0], {2, 0, 5});
    expect_near(triangles_of(scene)[0][1], {1, 2, 0});
}

TEST_F(LoadGltfSkins, MoveVerticesWithoutWeightsWithTheirFirstJoint) {
    GltfFile file = skinned_triangle();
    file.primitive()["attributes"]["WEIGHTS_0"] =
        file.add_accessor<float>({0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, f32, "VEC4");
    const Scene scene = load(file);
    expect_near(triangles_of(scene)[0][0], {0, 0, 5});
    EXPECT_TRUE(has_warning(scene, "vertices without weights"));
}

TEST_F(LoadGltfSkins, AreIgnoredWithAWarningWhereTheyCannotBeUsed) {
    GltfFile file = skinned_triangle();
    file.document["scenes"][0]["nodes"] = {0, 1};
    EXPECT_EQ(triangles_of(load(file))[0][0], Vec3(100, 0, 0));
    EXPECT_TRUE(has_warning(load(file), "skins ignored"));
    file = skinned_triangle();
    file.primitive()["attributes"].erase("JOINTS_0");
    EXPECT_EQ(triangles_of(load(file))[0][0], Vec3(100, 0, 0));
    EXPECT_TRUE(has_warning(load(file), "skins ignored"));
}

TEST_F(LoadGltfSkins, AreRefusedWithWrongIndicesTypesAndLengths) {
    const GltfFile sound = skinned_triangle();
    const auto expect_refused = [&](const char* place, const Json& value, const std::string& part) {
        GltfFile file = sound;
        file.document[Json::json_pointer(place)] = value;
        expect_error(file, part);
    };
    expect_refused("/nodes/0/skin", 1, "skin is 1");
    expect_refused("/skins/0/joints/1", 3, "joints/1 is 3");
    expect_refused("/skins/0/inverseBindMatrices", 99, "inverseBindMatrices is 99");
    expect_refused("/skins/0/inverseBindMatrices", 0, "MAT4");
    expect_refused("/skins/0/joints", {1, 2, 1}, "more joints");
    expect_refused("/meshes/0/primitives/0/attributes/JOINTS_0", 0, "VEC4");
    expect_refused("/skins/0/joints", {1}, "");
    GltfFile file = sound;
    file.primitive()["attributes"]["JOINTS_0"] =
        file.add_accessor<std::uint8_t>({0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0}, u8, "VEC4");
    expect_error(file, "joint 2 is beyond the 2 joints");
    file = sound;
    file.primitive()["attributes"].erase("WEIGHTS_0");
    expect_error(file, "no WEIGHTS_0");
    file = sound;
    std::vector<float> projecting(32, 1.0f);
    const int matrices = file.add_accessor<float>(projecting, f32, "SCALAR");
    file.accessor(matrices).update({{"type", "MAT4"}, {"count", 2}});
    file.document["skins"][0]["inverseBindMatrices"] = matrices;
    expect_error(file, "last row");
}

}  // namespace
