// glTF loader: which nodes are drawn and how often, and primitives that share accessors.
#include <numbers>

#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

using LoadGltfInstances = LoadGltf;
using LoadGltfVisibility = LoadGltf;
using LoadGltfSharedAccessors = LoadGltf;

// ---- EXT_mesh_gpu_instancing ----

GltfFile instanced_triangle(const char* attribute, int accessor, GltfFile file) {
    file.document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    file.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"][attribute] = accessor;
    return file;
}

TEST_F(LoadGltfInstances, AreDrawnAtEachTranslation) {
    GltfFile file = one_triangle();
    const int translation = file.add_accessor<float>({0, 0, 1, 2, 0, 0, 0, 3, 0}, f32, "VEC3");
    file = instanced_triangle("TRANSLATION", translation, file);
    file.node().update({{"name", "lamp"}, {"scale", {2, 2, 2}}});
    Json elsewhere = file.primitive();
    elsewhere["attributes"]["POSITION"] = file.add_accessor<float>({0, 0, 5, 1, 0, 5, 0, 1, 5}, f32, "VEC3");
    elsewhere["material"] = 0;
    file.primitive()["material"] = 0;
    file.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    file.document["meshes"][0]["primitives"].push_back(elsewhere);
    const Scene scene = load(file);
    ASSERT_EQ(scene.instance.size(), 6u);
    EXPECT_EQ(scene.instance[0].name, "lamp/0[0]");
    EXPECT_EQ(scene.instance[5].name, "lamp/1[2]");
    EXPECT_EQ(scene.instance[1].first_triangle, 1u);
    EXPECT_EQ(scene.instance_of, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(scene.position.size(), 18u) << "vertices of its own for each";
    EXPECT_EQ(triangles_of(scene)[1], (std::array<Vec3, 3>{Vec3(4, 0, 0), Vec3(6, 0, 0), Vec3(4, 2, 0)}))
        << "under the node's scale";
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfInstances, AreScaledThenRotatedThenMoved) {
    const float half = std::numbers::sqrt2_v<float> / 2;
    GltfFile file = one_triangle();
    const int translation = file.add_accessor<float>({0, 0, 5}, f32, "VEC3");
    const int scale = file.add_accessor<float>({2, 1, 1}, f32, "VEC3");
    const int floats = file.add_accessor<float>({0, 0, half, half}, f32, "VEC4");
    const int shorts = file.add_accessor<std::int16_t>({0, 0, 23170, 23170}, i16, "VEC4");
    const int bytes = file.add_accessor<std::int8_t>({0, 0, 90, 90}, 5120, "VEC4");
    file.accessor(shorts)["normalized"] = true;
    file.accessor(bytes)["normalized"] = true;
    file = instanced_triangle("TRANSLATION", translation, file);
    Json& attributes = file.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes["SCALE"] = scale;
    for (const int rotation : {floats, shorts, bytes}) {
        attributes["ROTATION"] = rotation;
        const Scene scene = load(file);
        expect_near(scene.position[1], {0, 2, 5});
        expect_near(scene.position[2], {-1, 0, 5});
    }
}

TEST_F(LoadGltfInstances, AreMirroredBeforeTheirNode) {
    GltfFile file = one_triangle();
    const int scale = file.add_accessor<float>({-1, 1, 1, 1, 1, 1}, f32, "VEC3");
    file = instanced_triangle("SCALE", scale, file);
    const Scene scene = load(file);
    expect_near(scene.geometric_normal[0], {0, 0, 1});
    expect_near(scene.geometric_normal[1], {0, 0, 1});
}

TEST_F(LoadGltfInstances, OfNothingAreLeftOut) {
    GltfFile file = one_triangle();
    const int scale = file.add_accessor<float>({0, 0, 0, 1, 1, 1}, f32, "VEC3");
    file = instanced_triangle("SCALE", scale, file);
    EXPECT_EQ(load(file).instance.size(), 1u);
}

TEST_F(LoadGltfInstances, AreCountedByAttributesOfTheApplicationToo) {
    GltfFile file = one_triangle();
    const int id = file.add_accessor<std::uint16_t>({1, 2}, u16, "SCALAR");
    file = instanced_triangle("_ID", id, file);
    Scene scene = load(file);
    EXPECT_TRUE(has_warning(scene, "1 triangle")) << "both are at one place: one of them is kept";
    file = instanced_triangle("COLOR", id, file);
    EXPECT_TRUE(has_warning(load(file), "instance attribute COLOR ignored"));
}

TEST_F(LoadGltfInstances, AreRefusedWithWrongIndicesTypesAndLengths) {
    GltfFile file = one_triangle();
    const int three = file.add_accessor<float>({0, 0, 1, 2, 0, 0, 0, 3, 0}, f32, "VEC3");
    const int two = file.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1}, f32, "VEC4");
    expect_error(instanced_triangle("TRANSLATION", 99, file), "TRANSLATION is 99");
    expect_error(instanced_triangle("TRANSLATION", two, file), "VEC3");
    expect_error(instanced_triangle("ROTATION", two, instanced_triangle("TRANSLATION", three, file)),
                 "has 3 elements, others have 2");
    const int nothing = file.add_accessor<float>({0, 0, 0, 0}, f32, "VEC4");
    expect_error(instanced_triangle("ROTATION", nothing, file), "quaternion");
    const int infinite =
        file.add_accessor<float>({std::numeric_limits<float>::infinity(), 1, 1}, f32, "VEC3");
    expect_error(instanced_triangle("SCALE", infinite, file), "not finite");
    file = instanced_triangle("SCALE", three, file);
    file.node()["extensions"]["EXT_mesh_gpu_instancing"] = Json::object();
    expect_error(file, "no attributes");
}

TEST_F(LoadGltfInstances, MoreThanThereIsMemoryForAreRefusedBeforeAnyIsTaken) {
    GltfFile file = one_triangle();
    const int numbers = file.add_accessor<float>({0, 0, 0}, f32, "SCALAR");
    file.accessor(numbers)["count"] = 4000000000u;
    expect_error(instanced_triangle("_ID", numbers, file), "4000000000 instances");
}

// ---- KHR_node_visibility ----

GltfFile hidden_triangle(bool is_visible) {
    GltfFile file = one_triangle();
    file.document["extensionsRequired"] = {"KHR_node_visibility", "KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
    const Json lit = {{"KHR_lights_punctual", {{"light", 0}}}};
    const Json visibility = {{"KHR_node_visibility", {{"visible", is_visible}}}};
    file.document["nodes"] = {
        {{"mesh", 0}, {"extensions", lit}},
        {{"children", {2}}, {"extensions", visibility}},
        {{"mesh", 0},
         {"translation", {0, 0, 5}},
         {"camera", 0},
         {"extensions",
          {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", true}}}}}}};
    file.document["scenes"][0]["nodes"] = {0, 1};
    file.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    return file;
}

TEST_F(LoadGltfVisibility, HidesMeshesAndLightsBelowANodeButNoCameras) {
    Scene scene = load(hidden_triangle(true));
    EXPECT_EQ(scene.instance.size(), 2u);
    EXPECT_EQ(scene.point_light.size(), 2u);
    EXPECT_EQ(scene.camera.size(), 1u);
    scene = load(hidden_triangle(false));
    EXPECT_EQ(scene.instance.size(), 1u);
    EXPECT_EQ(scene.point_light.size(), 1u);
    EXPECT_EQ(scene.camera.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfVisibility, IsTrueOrFalse) {
    GltfFile file = hidden_triangle(true);
    file.node(1)["extensions"]["KHR_node_visibility"]["visible"] = 0;
    expect_error(file, "visible has the wrong type");
}

// ---- Nodes that are scaled to nothing ----

TEST_F(LoadGltfVisibility, LeavesOutWhatHasNoDirectionUnderANodeThatIsScaledToNothing) {
    GltfFile file = hidden_triangle(true);
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}}, {{"type", "spot"}, {"spot", Json::object()}}, {{"type", "directional"}}};
    file.node(1)["scale"] = {0, 0, 0};
    file.node(2)["translation"] = {1, 2, 3};
    Scene scene = load(file);
    EXPECT_EQ(scene.instance.size(), 1u);
    EXPECT_EQ(scene.point_light.size(), 2u) << "a point has no direction to lose";
    EXPECT_EQ(scene.point_light[1].position, Vec3(0, 0, 0));
    EXPECT_TRUE(scene.camera.empty());
    EXPECT_TRUE(has_warning(scene, "cameras left out"));
    EXPECT_FALSE(has_warning(scene, "lights left out"));
    for (const int light : {1, 2}) {
        file.node(2)["extensions"]["KHR_lights_punctual"]["light"] = light;
        scene = load(file);
        EXPECT_TRUE(scene.spot_light.empty());
        EXPECT_TRUE(scene.directional_light.empty());
        EXPECT_TRUE(has_warning(scene, "lights left out"));
    }
    // Scaled to zero along their viewing direction, so no direction remains.
    file.node(1)["scale"] = {1, 1, 0};
    EXPECT_TRUE(has_warning(load(file), "lights left out"));
    EXPECT_TRUE(has_warning(load(file), "cameras left out"));
    // Scaled to zero across it: a direction remains, but the camera's up vector does not.
    file.node(1)["scale"] = {1, 0, 1};
    EXPECT_EQ(load(file).directional_light.size(), 1u);
    EXPECT_TRUE(has_warning(load(file), "cameras left out"));
}

// ---- Shared accessors ----

/// Makes `count` primitives of one triangle each, which share one buffer view of indices and a very long list
/// of vertices, nearly all of them unused.
GltfFile shared_vertices(std::uint16_t count) {
    GltfFile file = one_triangle();
    std::vector<std::uint16_t> places;
    std::vector<float> positions;
    for (std::uint16_t i = 0; i < 3 * count; ++i) {
        places.push_back(i);
        positions.insert(positions.end(),
                         {static_cast<float>(i / 3 + (i % 3 == 1)), i % 3 == 2 ? 1.0f : 0.0f, 0});
    }
    const int vertices = file.add_view(bytes_of(positions));
    const int indices = file.add_view(bytes_of(places));
    file.document["accessors"] = {{{"componentType", f32},
                                   {"count", 16'000'000},
                                   {"type", "VEC3"},
                                   {"sparse",
                                    {{"count", places.size()},
                                     {"indices", {{"bufferView", indices}, {"componentType", u16}}},
                                     {"values", {{"bufferView", vertices}}}}}}};
    Json primitives = Json::array();
    for (int i = 0; i < count; ++i) {
        file.document["accessors"].push_back({{"bufferView", indices},
                                              {"byteOffset", 6 * i},
                                              {"componentType", u16},
                                              {"count", 3},
                                              {"type", "SCALAR"}});
        primitives.push_back({{"attributes", {{"POSITION", 0}, {"NORMAL", 0}}}, {"indices", i + 1}});
    }
    file.document["meshes"][0]["primitives"] = primitives;
    return file;
}

TEST_F(LoadGltfSharedAccessors, CostWhatIsUsedOfThem) {
    // Reading all vertices for each primitive would mean reading a terabyte.
    const Scene scene = load(shared_vertices(2000));
    ASSERT_EQ(scene.instance.size(), 2000u);
    EXPECT_EQ(scene.position.size(), 6000u);
    EXPECT_EQ(triangles_of(scene)[1999],
              (std::array<Vec3, 3>{Vec3(1999, 0, 0), Vec3(2000, 0, 0), Vec3(1999, 1, 0)}));
}

TEST_F(LoadGltfSharedAccessors, AreStillCheckedAsAWhole) {
    GltfFile file = shared_vertices(2);
    file.document["accessors"][2]["byteOffset"] = 8;
    expect_error(file, "accessors/2 goes beyond");
    file = shared_vertices(2);
    file.document["accessors"][0]["count"] = 5;
    expect_error(file, "sparse index");
}

TEST_F(LoadGltfSharedAccessors, KeepTheOrderOfTheirVertices) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["POSITION"] =
        file.add_accessor<float>({7, 7, 7, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0}, f32, "VEC3");
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({7, 7, 7, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, "VEC3");
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({2, 3, 1, 1, 3, 4}, u8, "SCALAR");
    const Scene scene = load(file);
    EXPECT_EQ(scene.position,
              (std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}));
    EXPECT_EQ(scene.triangle, (std::vector<common::TriangleVertices>{{0, 1, 2}, {2, 1, 3}}));
}

}  // namespace
