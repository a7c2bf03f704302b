#include "common/gltf/load_gltf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "common/core/input_error.h"
#include "tests/gltf_text.h"

namespace {

using common::Rgb;
using common::Scene;
using common::SurfaceKind;
using common::Vec2;
using common::Vec3;
using namespace gltf_text;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

void expect_near(const Vec3& value, const Vec3& expected, float tolerance = 1e-6f) {
    EXPECT_LE((value - expected).length(), tolerance) << value << " instead of " << expected;
}

bool has_warning(const Scene& scene, const std::string& part) {
    for (const std::string& warning : scene.warnings) {
        if (warning.find(part) != std::string::npos) return true;
    }
    return false;
}

/// One triangle with both sets of texture coordinates and a material without textures.
GltfFile textured_triangle() {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["TEXCOORD_0"] = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, f32, "VEC2");
    file.primitive()["attributes"]["TEXCOORD_1"] = file.primitive()["attributes"]["TEXCOORD_0"];
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "red green.png"}}};
    file.material() = Json::object();
    return file;
}

class LoadGltf : public testing::Test {
  protected:
    [[nodiscard]] Scene load(const GltfFile& file) const { return common::load_gltf(file.write(directory)); }

    /// The message with which `file` is refused.
    [[nodiscard]] static std::string error_of(const std::filesystem::path& file) {
        try {
            (void)common::load_gltf(file);
        } catch (const common::InputError& error) {
            return error.what();
        }
        return "loaded";
    }
    void expect_error(const std::filesystem::path& file, const std::string& part) const {
        const std::string error = error_of(file);
        EXPECT_NE(error.find(part), std::string::npos) << error;
        EXPECT_EQ(error.find(file.string()), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    void expect_error(const GltfFile& file, const std::string& part) const {
        expect_error(file.write(directory), part);
    }

    /// Textured triangle with one value put in at the JSON pointer `place`.
    void expect_change_refused(const char* place, const Json& value, const std::string& part) const {
        GltfFile file = textured_triangle();
        file.document[Json::json_pointer(place)] = value;
        expect_error(file, part);
    }

    TemporaryDirectory directory;
};

using LoadGltfGeometry = LoadGltf;
using LoadGltfNodes = LoadGltf;
using LoadGltfMaterials = LoadGltf;
using LoadGltfTextures = LoadGltf;
using LoadGltfLights = LoadGltf;
using LoadGltfCameras = LoadGltf;
using LoadGltfErrors = LoadGltf;

/// The triangles' corners, as positions.
std::vector<std::array<Vec3, 3>> triangles_of(const Scene& scene) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const auto& [a, b, c] : scene.triangle)
        triangles.push_back({scene.position[a], scene.position[b], scene.position[c]});
    return triangles;
}

// ---- Geometry ----

TEST_F(LoadGltfGeometry, ReadsATriangle) {
    const Scene scene = load(one_triangle());
    ASSERT_EQ(triangles_of(scene),
              (std::vector<std::array<Vec3, 3>>{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}));
    EXPECT_EQ(scene.geometric_normal, (std::vector<Vec3>{Vec3(0, 0, 1)}));
    EXPECT_EQ(scene.normal, (std::vector<Vec3>(3, Vec3(0, 0, 1)))) << "flat without NORMAL";
    EXPECT_EQ(scene.tangent, (std::vector<Vec3>(3, Vec3(0))));
    EXPECT_EQ(scene.tangent_sign.size(), 3u);
    EXPECT_EQ(scene.texcoord[0], (std::vector<Vec2>(3, Vec2(0))));
    EXPECT_EQ(scene.texcoord[1], (std::vector<Vec2>(3, Vec2(0))));
    ASSERT_EQ(scene.instance.size(), 1u);
    EXPECT_EQ(scene.instance[0].triangle_count, 1u);
    EXPECT_FALSE(scene.instance[0].has_texcoord[0]);
    EXPECT_EQ(scene.instance_of, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(scene.bounds.max, Vec3(1, 1, 0));
    EXPECT_FLOAT_EQ(common::triangle_area(scene, 0), 0.5f);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.source, (directory.path() / "scene.gltf").string());
}

TEST_F(LoadGltfGeometry, ReadsAGlb) {
    EXPECT_EQ(common::load_gltf(directory.write("scene.glb", one_triangle().glb())).triangle.size(), 1u);
}

TEST_F(LoadGltfGeometry, ReadsABufferInADataUri) {
    GltfFile file = one_triangle();
    // Nine floats: 0 0 0  1 0 0  0 1 0.
    const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    file.document["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64}}};
    EXPECT_EQ(load(file).triangle.size(), 1u);
}

TEST_F(LoadGltfGeometry, ReadsABufferFileThatIsLongerThanTheBuffer) {
    GltfFile file = one_triangle();
    file.buffer.resize(50);
    file.document["buffers"] = {{{"byteLength", 36}, {"uri", "dat%61.bin"}}};
    EXPECT_EQ(load(file).triangle.size(), 1u);
}

TEST_F(LoadGltfGeometry, ReadsIndicesOfEveryType) {
    for (const int type : {u8, u16, u32}) {
        GltfFile file = one_triangle();
        if (type == u8)
            file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 2, 1}, u8, "SCALAR");
        if (type == u16)
            file.primitive()["indices"] = file.add_accessor<std::uint16_t>({0, 2, 1}, u16, "SCALAR");
        if (type == u32)
            file.primitive()["indices"] = file.add_accessor<std::uint32_t>({0, 2, 1}, u32, "SCALAR");
        EXPECT_EQ(load(file).geometric_normal, (std::vector<Vec3>{Vec3(0, 0, -1)})) << type;
    }
}

/// Four corners of the unit square, in the order of a strip.
GltfFile square(int mode) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["POSITION"] =
        file.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, f32, "VEC3");
    file.primitive()["mode"] = mode;
    return file;
}

TEST_F(LoadGltfGeometry, ReadsStripsAllFacingTheSameWay) {
    const Scene scene = load(square(5));
    EXPECT_EQ(scene.geometric_normal, (std::vector<Vec3>(2, Vec3(0, 0, 1))));
    EXPECT_FLOAT_EQ(common::triangle_area(scene, 0) + common::triangle_area(scene, 1), 1);
}

TEST_F(LoadGltfGeometry, ReadsFansAroundTheirFirstVertex) {
    GltfFile file = square(6);
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 3, 2}, u8, "SCALAR");
    const Scene scene = load(file);
    EXPECT_EQ(scene.geometric_normal, (std::vector<Vec3>(2, Vec3(0, 0, 1))));
    EXPECT_FLOAT_EQ(common::triangle_area(scene, 0) + common::triangle_area(scene, 1), 1);
}

TEST_F(LoadGltfGeometry, LeavesOutPointsAndLines) {
    for (const int mode : {0, 1, 2, 3}) {
        GltfFile file = one_triangle();
        Json line = file.primitive();
        line["mode"] = mode;
        file.document["meshes"][0]["primitives"].push_back(line);
        const Scene scene = load(file);
        EXPECT_EQ(scene.triangle.size(), 1u);
        EXPECT_TRUE(has_warning(scene, "points or lines"));
    }
}

TEST_F(LoadGltfGeometry, SharesVerticesWhereThereAreNormalsOnly) {
    GltfFile file = square(5);
    EXPECT_EQ(load(file).position.size(), 6u);
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 3, 4}, f32, "VEC3");
    const Scene scene = load(file);
    EXPECT_EQ(scene.position.size(), 4u);
    expect_near(scene.normal[0], {0, 0, 1});
    expect_near(scene.normal[3], {0, 0.6f, 0.8f});
}

TEST_F(LoadGltfGeometry, ReadsBothSetsOfTextureCoordinates) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["TEXCOORD_0"] = file.add_accessor<float>({0, 0, 2, 0, 0, 3}, f32, "VEC2");
    const int normalized = file.add_accessor<std::uint16_t>({0, 0, 65535, 0, 0, 13107}, u16, "VEC2");
    file.accessor(normalized)["normalized"] = true;
    file.primitive()["attributes"]["TEXCOORD_1"] = normalized;
    const Scene scene = load(file);
    EXPECT_EQ(scene.texcoord[0], (std::vector<Vec2>{Vec2(0), Vec2(2, 0), Vec2(0, 3)}));
    EXPECT_EQ(scene.texcoord[1], (std::vector<Vec2>{Vec2(0), Vec2(1, 0), Vec2(0, 0.2f)}));
    EXPECT_TRUE(scene.instance[0].has_texcoord[0] && scene.instance[0].has_texcoord[1]);
}

TEST_F(LoadGltfGeometry, ReadsNormalizedBytesAsTextureCoordinates) {
    GltfFile file = one_triangle();
    // Rows of two bytes padded to four.
    const int texcoord =
        file.add_accessor<std::uint8_t>({0, 0, 9, 9, 255, 51, 9, 9, 0, 255, 9, 9}, u8, "VEC2");
    file.accessor(texcoord).update({{"normalized", true}, {"count", 3}});
    file.view(file.accessor(texcoord)["bufferView"])["byteStride"] = 4;
    file.primitive()["attributes"]["TEXCOORD_0"] = texcoord;
    EXPECT_EQ(load(file).texcoord[0], (std::vector<Vec2>{Vec2(0), Vec2(1, 0.2f), Vec2(0, 1)}));
}

TEST_F(LoadGltfGeometry, ReadsQuantizedPositionsAndNormals) {
    GltfFile file = one_triangle();
    file.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int position =
        file.add_accessor<std::int16_t>({0, 0, 0, 0, 300, 0, 0, 0, 0, 300, 0, 0}, i16, "VEC3");
    const int normal =
        file.add_accessor<std::int16_t>({0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, 32767, 0}, i16, "VEC3");
    for (const int accessor : {position, normal}) {
        file.accessor(accessor)["count"] = 3;
        file.view(file.accessor(accessor)["bufferView"])["byteStride"] = 8;
    }
    file.accessor(normal)["normalized"] = true;
    file.primitive()["attributes"] = {{"POSITION", position}, {"NORMAL", normal}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.position[1], Vec3(300, 0, 0));
    EXPECT_EQ(scene.normal[1], Vec3(0, 0, 1));
}

TEST_F(LoadGltfGeometry, ReadsInterleavedAttributes) {
    GltfFile file = one_triangle();
    const int interleaved =
        file.add_accessor<float>({0, 0, 0, 0.5f, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0.25f, 0}, f32, "VEC3");
    file.accessor(interleaved)["count"] = 3;
    Json texcoord = file.accessor(interleaved);
    texcoord.update({{"type", "VEC2"}, {"byteOffset", 12}});
    file.document["accessors"].push_back(texcoord);
    file.view(file.accessor(interleaved)["bufferView"])["byteStride"] = 20;
    file.primitive()["attributes"] = {{"POSITION", interleaved}, {"TEXCOORD_0", interleaved + 1}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.position[2], Vec3(0, 1, 0));
    EXPECT_EQ(scene.texcoord[0], (std::vector<Vec2>{Vec2(0.5f, 0), Vec2(0, 1), Vec2(0.25f, 0)}));
}

TEST_F(LoadGltfGeometry, PutsInSparseElements) {
    GltfFile file = one_triangle();
    const int indices = file.add_view(bytes_of<std::uint16_t>({1}));
    const int values = file.add_view(bytes_of<float>({5, 0, 0}));
    file.accessor(0)["sparse"] = {{"count", 1},
                                  {"indices", {{"bufferView", indices}, {"componentType", u16}}},
                                  {"values", {{"bufferView", values}}}};
    EXPECT_EQ(load(file).position[1], Vec3(5, 0, 0));
}

TEST_F(LoadGltfGeometry, StartsSparseElementsWithoutABufferViewFromZero) {
    GltfFile file = one_triangle();
    const int indices = file.add_view(bytes_of<std::uint8_t>({1, 2}));
    const int values = file.add_view(bytes_of<float>({5, 0, 0, 0, 6, 0}));
    file.accessor(0).erase("bufferView");
    file.accessor(0)["sparse"] = {{"count", 2},
                                  {"indices", {{"bufferView", indices}, {"componentType", u8}}},
                                  {"values", {{"bufferView", values}}}};
    EXPECT_EQ(triangles_of(load(file))[0], (std::array<Vec3, 3>{Vec3(0), Vec3(5, 0, 0), Vec3(0, 6, 0)}));
}

TEST_F(LoadGltfGeometry, LeavesOutAndCountsTrianglesWithoutArea) {
    GltfFile file = one_triangle();
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 2, 0, 1, 1, 2, 2, 2}, u8, "SCALAR");
    const Scene scene = load(file);
    EXPECT_EQ(scene.triangle.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "zero-area triangles left out: 2"));
}

TEST_F(LoadGltfGeometry, IgnoresVerticesThatDoNotMakeATriangle) {
    GltfFile file = one_triangle();
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 2, 0, 1}, u8, "SCALAR");
    EXPECT_EQ(load(file).triangle.size(), 1u);
}

TEST_F(LoadGltfGeometry, ReplacesBrokenNormalsAndTextureCoordinates) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({nan_value, 0, 1, 0, 0, 0, 1, 0, 0}, f32, "VEC3");
    file.primitive()["attributes"]["TEXCOORD_0"] =
        file.add_accessor<float>({nan_value, 1, 1, 1, 1, 1}, f32, "VEC2");
    const Scene scene = load(file);
    EXPECT_EQ(scene.normal, (std::vector<Vec3>{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(1, 0, 0)}));
    EXPECT_EQ(scene.texcoord[0][0], Vec2(0));
    EXPECT_TRUE(has_warning(scene, "normals that are not finite"));
    EXPECT_TRUE(has_warning(scene, "texture coordinates that are not finite"));
}

TEST_F(LoadGltfGeometry, LeavesSkinsAndMorphTargetsAtRest) {
    GltfFile file = one_triangle();
    file.primitive()["targets"] = {{{"POSITION", 0}}};
    file.document["skins"] = {{{"joints", {0}}}};
    file.node()["skin"] = 0;
    const Scene scene = load(file);
    EXPECT_EQ(scene.position[1], Vec3(1, 0, 0));
    EXPECT_TRUE(has_warning(scene, "skin"));
    EXPECT_TRUE(has_warning(scene, "morph targets"));
}

TEST_F(LoadGltfGeometry, ReadsIntegersWrittenAsFloats) {
    GltfFile file = one_triangle();
    const int indices = file.add_accessor<std::uint8_t>({0, 2, 1}, u8, "SCALAR");
    file.primitive()["indices"] = static_cast<double>(indices);
    file.accessor(0)["count"] = 3.0;
    EXPECT_EQ(load(file).geometric_normal[0], Vec3(0, 0, -1));
}

// ---- Nodes ----

TEST_F(LoadGltfNodes, AppliesScaleThenRotationThenTranslation) {
    GltfFile file = one_triangle();
    const double half = std::numbers::sqrt2 / 2;
    file.node().update({{"scale", {2, 1, 1}}, {"rotation", {0, 0, half, half}}, {"translation", {0, 0, 5}}});
    const Scene scene = load(file);
    expect_near(scene.position[1], {0, 2, 5});
    expect_near(scene.position[2], {-1, 0, 5});
}

TEST_F(LoadGltfNodes, ReadsMatricesColumnByColumn) {
    GltfFile file = one_triangle();
    file.node()["matrix"] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1};
    const Scene scene = load(file);
    expect_near(scene.position[1], {0, 2, 5});
    expect_near(scene.position[2], {-1, 0, 5});
}

TEST_F(LoadGltfNodes, ComposesRotatedChildrenOfScaledParents) {
    GltfFile file = one_triangle();
    const double half = std::numbers::sqrt2 / 2;
    file.document["nodes"] = {{{"children", {1}}, {"scale", {3, 1, 1}}, {"translation", {0, 10, 0}}},
                              {{"mesh", 0}, {"rotation", {0, 0, half, half}}}};
    const Scene scene = load(file);
    expect_near(scene.position[1], {0, 11, 0});
    expect_near(scene.position[2], {-3, 10, 0});
}

TEST_F(LoadGltfNodes, KeepsNormalsPerpendicularUnderScaling) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["POSITION"] =
        file.add_accessor<float>({1, 0, 0, 1, 0, -1, 0, 1, 0}, f32, "VEC3");
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({1, 1, 0, 1, 1, 0, 1, 1, 0}, f32, "VEC3");
    file.node()["scale"] = {4, 1, 1};
    const Scene scene = load(file);
    expect_near(scene.normal[0], Vec3(1, 4, 0).normalized());
    expect_near(scene.geometric_normal[0], scene.normal[0]);
}

TEST_F(LoadGltfNodes, TurnsMirroredTrianglesRound) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["NORMAL"] =
        file.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, "VEC3");
    file.primitive()["attributes"]["TANGENT"] =
        file.add_accessor<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, f32, "VEC4");
    file.node()["scale"] = {-1, 1, 1};
    const Scene scene = load(file);
    expect_near(scene.geometric_normal[0], {0, 0, 1});
    expect_near(scene.normal[0], {0, 0, 1});
    expect_near(scene.tangent[0], {-1, 0, 0});
    // The bitangent of the file is +y and stays that.
    expect_near(scene.normal[0].cross(scene.tangent[0]) * scene.tangent_sign[0], {0, 1, 0});
}

TEST_F(LoadGltfNodes, MakesAnInstanceOfEveryPrimitiveUnderEveryNode) {
    GltfFile file = one_triangle();
    file.document["meshes"][0]["name"] = "mesh";
    file.document["meshes"][0]["primitives"].push_back(file.primitive());
    file.document["nodes"] = {{{"mesh", 0}, {"name", "left"}}, {{"mesh", 0}, {"translation", {2, 0, 0}}}};
    file.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(file);
    ASSERT_EQ(scene.instance.size(), 4u);
    EXPECT_EQ(scene.instance[0].name, "left/0");
    EXPECT_EQ(scene.instance[3].name, "mesh/1");
    EXPECT_EQ(scene.instance[3].first_triangle, 3u);
    EXPECT_EQ(scene.instance_of, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(scene.position.size(), 12u);
}

TEST_F(LoadGltfNodes, TakesTheDefaultSceneElseTheFirstElseAllRoots) {
    GltfFile file = one_triangle();
    file.document["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"mesh", 0}}, {{"mesh", 0}}};
    file.document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {2}}}};
    file.document["scene"] = 1;
    EXPECT_EQ(load(file).instance.size(), 1u);
    file.document.erase("scene");
    EXPECT_EQ(load(file).instance.size(), 2u);
    file.document.erase("scenes");
    EXPECT_EQ(load(file).instance.size(), 3u);
}

TEST_F(LoadGltfNodes, FollowsVeryDeepTrees) {
    GltfFile file = one_triangle();
    const int deepest = 20000;
    file.document["nodes"] = Json::array();
    for (int i = 0; i < deepest; ++i) file.document["nodes"].push_back({{"children", {i + 1}}});
    file.document["nodes"].push_back({{"mesh", 0}});
    EXPECT_EQ(load(file).triangle.size(), 1u);
}

TEST_F(LoadGltfNodes, RefusesLoopsAndSecondParents) {
    GltfFile file = one_triangle();
    file.document["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {0}}}};
    expect_error(file, "loop");
    file.document["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
    expect_error(file, "loop");
    file.document["nodes"] = {{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    expect_error(file, "two parents");
}

TEST_F(LoadGltfNodes, RefusesTransformsThatAreNotFiniteOrNotAffine) {
    GltfFile file = one_triangle();
    file.node()["scale"] = {1e39, 1, 1};
    expect_error(file, "scale");
    file.document["nodes"] = {{{"children", {1}}, {"scale", {1e30, 1, 1}}},
                              {{"mesh", 0}, {"scale", {1e30, 1, 1}}}};
    expect_error(file, "not finite");
    file.document["nodes"] = {{{"mesh", 0}, {"rotation", {0, 0, 0, 0}}}};
    expect_error(file, "quaternion");
    file.document["nodes"] = {{{"mesh", 0}, {"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
    expect_error(file, "last row");
    file.document["nodes"] = {{{"mesh", 0}, {"matrix", {1, 0, 0}}}};
    expect_error(file, "nodes/0/matrix");
}

// ---- Materials ----

TEST_F(LoadGltfMaterials, GivesGltfsDefaultMaterialWhereNoneIsNamed) {
    const Scene scene = load(one_triangle());
    const common::Material& material = scene.material_of(0);
    EXPECT_EQ(material.kind, SurfaceKind::diffuse);
    EXPECT_EQ(material.base_color, Rgb(1, 1, 1));
    EXPECT_FALSE(material.emits());
    EXPECT_FALSE(material.double_sided);
}

TEST_F(LoadGltfMaterials, ReadsADiffuseMaterial) {
    GltfFile file = one_triangle();
    file.material() = {{"name", "wall"},
                       {"doubleSided", true},
                       {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}}}};
    const common::Material material = load(file).material_of(0);
    EXPECT_EQ(material.name, "wall");
    EXPECT_EQ(material.kind, SurfaceKind::diffuse);
    EXPECT_EQ(material.base_color, Rgb(0.5f, 0.25f, 1));
    EXPECT_TRUE(material.double_sided);
}

TEST_F(LoadGltfMaterials, ClampsTheBaseColor) {
    GltfFile file = one_triangle();
    file.material()["pbrMetallicRoughness"]["baseColorFactor"] = {2, -1, 0.5, 1};
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].base_color, Rgb(1, 0, 0.5f));
    EXPECT_TRUE(has_warning(scene, "clamped"));
}

TEST_F(LoadGltfMaterials, ReadsSmoothMetalAsMirror) {
    GltfFile file = one_triangle();
    Json& pbr = file.material()["pbrMetallicRoughness"];
    pbr = {{"roughnessFactor", 0}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::mirror) << "metallic by default";
    pbr = {{"roughnessFactor", 0.1}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
    pbr = {{"roughnessFactor", 0}, {"metallicFactor", 0.5}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "missing.png"}}};
    pbr = {{"roughnessFactor", 0}, {"metallicRoughnessTexture", {{"index", 0}}}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
}

TEST_F(LoadGltfMaterials, ReadsTransmissionAsDielectric) {
    GltfFile file = one_triangle();
    Json& material = file.material();
    material["pbrMetallicRoughness"] = {{"roughnessFactor", 0}, {"metallicFactor", 0}};
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::dielectric);
    EXPECT_EQ(scene.material[0].index_of_refraction, 1.5f);
    EXPECT_TRUE(scene.warnings.empty());

    material["extensions"]["KHR_materials_ior"] = {{"ior", 1.25}};
    EXPECT_EQ(load(file).material[0].index_of_refraction, 1.25f);

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.75}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::dielectric);
    EXPECT_TRUE(has_warning(scene, "transmission"));

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.25}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
}

TEST_F(LoadGltfMaterials, WarnsAboutRoughGlassAndImpossibleIndices) {
    GltfFile file = one_triangle();
    file.material()["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5}};
    file.material()["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                     {"KHR_materials_ior", {{"ior", 0}}}};
    const Scene scene = load(file);
    EXPECT_TRUE(has_warning(scene, "rough transmission"));
    EXPECT_TRUE(has_warning(scene, "index of refraction"));
    EXPECT_EQ(scene.material[0].index_of_refraction, 1.5f);
}

TEST_F(LoadGltfMaterials, MultipliesEmissionByItsStrength) {
    GltfFile file = one_triangle();
    file.material()["emissiveFactor"] = {1, 0.5, 0};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(1, 0.5f, 0));
    file.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 100}};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(100, 50, 0));
    file.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 5e9}};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(5e9f, 2.5e9f, 0));
}

TEST_F(LoadGltfMaterials, TakesUnlitAsDiffuseThatDoesNotEmit) {
    GltfFile file = one_triangle();
    file.material()["emissiveFactor"] = {1, 1, 1};
    file.material()["extensions"]["KHR_materials_unlit"] = Json::object();
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse);
    EXPECT_FALSE(scene.material[0].emits());
    EXPECT_TRUE(has_warning(scene, "unlit"));
}

TEST_F(LoadGltfMaterials, TakesAlphaAsOpaque) {
    GltfFile file = one_triangle();
    file.material()["alphaMode"] = "BLEND";
    EXPECT_TRUE(has_warning(load(file), "opaque"));
}

// ---- Textures ----

TEST_F(LoadGltfTextures, ReadsAllThreeSlots) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.document["images"][0]["uri"] = "red%20green.png";
    file.material() = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                       {"normalTexture", {{"index", 0}, {"scale", 0.5}, {"texCoord", 1}}},
                       {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
                       {"emissiveFactor", {1, 1, 1}}};
    const Scene scene = load(file);
    const common::Material& material = scene.material[0];
    EXPECT_EQ(material.base_color_texture.texcoord_set, 0);
    EXPECT_EQ(material.normal_texture.texcoord_set, 1);
    EXPECT_EQ(material.emissive_texture.texcoord_set, 1);
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(material.base_color_texture.texture, material.emissive_texture.texture) << "the same colours";
    EXPECT_NE(material.base_color_texture.texture, material.normal_texture.texture) << "colours and data";
    ASSERT_EQ(scene.texture.size(), 2u);
    EXPECT_EQ(scene.texture[0].width(), 2);
    EXPECT_EQ(scene.texture[0].sample({0.25f, 0.5f}), Rgb(1, 0, 0));
    EXPECT_EQ(scene.texture[0].sample({0.75f, 0.5f}), Rgb(0, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfTextures, ReadsImagesInBufferViewsWithTheirSampler) {
    GltfFile file = textured_triangle();
    file.document["images"] = {{{"bufferView", file.add_view(red_green_png())}, {"mimeType", "image/png"}}};
    file.document["samplers"] = {{{"wrapS", 33071}}};
    file.document["textures"][0]["sampler"] = 0;
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Scene scene = common::load_gltf(directory.write("scene.glb", file.glb()));
    ASSERT_EQ(scene.texture.size(), 1u);
    EXPECT_EQ(scene.texture[0].sample({9, 0.5f}), Rgb(0, 1, 0)) << "clamped to the edge";
}

TEST_F(LoadGltfTextures, Reduces16BitsTo8) {
    directory.write("red green.png", sixteen_bit_png());
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    EXPECT_EQ(load(file).texture[0].sample({0.5f, 0.5f}), Rgb(1, 128.0f / 255, 0));
}

TEST_F(LoadGltfTextures, RefusesNeededImagesThatCannotBeRead) {
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    expect_error(file, "image 'red green.png' cannot be read");
    directory.write("red green.png", std::string("not a picture"));
    expect_error(file, "image 'red green.png' cannot be decoded");
    file.document["textures"][0]["source"] = 1;
    expect_error(file, "textures/0");
    file.document["textures"][0].erase("source");
    expect_error(file, "textures/0");
}

TEST_F(LoadGltfTextures, IgnoresBrokenImagesThatNothingReads) {
    GltfFile file = textured_triangle();
    file.document["images"] = {
        {{"uri", "data:image/png;base64,!"}}, Json::object(), {{"uri", "missing.png"}}};
    file.document["textures"] = {{{"source", 2}}, {{"source", 99}}};
    file.material()["occlusionTexture"] = {{"index", 0}};
    file.material()["emissiveTexture"] = {{"index", 0}};  // with emissiveFactor 0
    EXPECT_TRUE(load(file).texture.empty());
}

TEST_F(LoadGltfTextures, WarnsAboutWhatItCannotHonour) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.primitive()["attributes"].erase("TEXCOORD_0");
    file.material()["normalTexture"] = {{"index", 0}, {"texCoord", 2}};
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}}}}}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].normal_texture.texture, common::no_texture);
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_2"));
    EXPECT_TRUE(has_warning(scene, "KHR_texture_transform"));
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_0, which is missing"));
}

TEST_F(LoadGltfTextures, DoesNotWarnAboutATransformThatDoesNothing) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    const Json identity = {{"offset", {0, 0}}, {"scale", {1, 1}}, {"rotation", 0}};
    file.material()["normalTexture"] = {{"index", 0}, {"extensions", {{"KHR_texture_transform", identity}}}};
    EXPECT_TRUE(load(file).warnings.empty());
}

// ---- Lights ----

GltfFile lit_triangle(const Json& light, const Json& transform) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    Json node = transform;
    node["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    file.document["nodes"].push_back(node);
    file.document["scenes"][0]["nodes"] = {0, 1};
    return file;
}

TEST_F(LoadGltfLights, ReadsPointLights) {
    const Json light = {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 10}};
    const Scene scene = load(lit_triangle(light, {{"translation", {1, 2, 3}}, {"scale", {5, 5, 5}}}));
    ASSERT_EQ(scene.point_light.size(), 1u);
    EXPECT_EQ(scene.point_light[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(scene.point_light[0].intensity, Rgb(10, 5, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfLights, ReadsSpotLights) {
    const double half = std::numbers::sqrt2 / 2;
    // A quarter turn about x makes -z into +y.
    const Json pose = {{"rotation", {half, 0, 0, half}}, {"translation", {1, 2, 3}}};
    const Json cones = {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}};
    Scene scene = load(lit_triangle({{"type", "spot"}, {"spot", cones}, {"intensity", 2}}, pose));
    ASSERT_EQ(scene.spot_light.size(), 1u);
    expect_near(scene.spot_light[0].axis, {0, 1, 0});
    EXPECT_EQ(scene.spot_light[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(scene.spot_light[0].intensity, Rgb(2, 2, 2)) << "white by default";
    EXPECT_FLOAT_EQ(scene.spot_light[0].cos_inner_angle, std::cos(0.25f));
    EXPECT_FLOAT_EQ(scene.spot_light[0].cos_outer_angle, std::cos(0.5f));

    scene = load(lit_triangle({{"type", "spot"}, {"spot", Json::object()}}, pose));
    EXPECT_EQ(scene.spot_light[0].intensity, Rgb(1, 1, 1));
    EXPECT_FLOAT_EQ(scene.spot_light[0].cos_inner_angle, 1);
    EXPECT_FLOAT_EQ(scene.spot_light[0].cos_outer_angle, std::cos(std::numbers::pi_v<float> / 4));

    scene = load(
        lit_triangle({{"type", "spot"}, {"spot", {{"innerConeAngle", 2}, {"outerConeAngle", 1}}}}, pose));
    EXPECT_EQ(scene.spot_light[0].cos_inner_angle, scene.spot_light[0].cos_outer_angle);
    EXPECT_TRUE(has_warning(scene, "cone angles"));
}

TEST_F(LoadGltfLights, ReadsDirectionalLights) {
    const Scene scene =
        load(lit_triangle({{"type", "directional"}, {"intensity", 3}}, {{"scale", {1, 1, 7}}}));
    ASSERT_EQ(scene.directional_light.size(), 1u);
    EXPECT_EQ(scene.directional_light[0].direction, Vec3(0, 0, -1));
    EXPECT_EQ(scene.directional_light[0].irradiance, Rgb(3, 3, 3));
}

TEST_F(LoadGltfLights, RefusesWhatIsNoLight) {
    const Json pose = Json::object();
    expect_error(lit_triangle({{"type", "laser"}}, pose), "laser");
    expect_error(lit_triangle({{"type", "point"}, {"intensity", -1}}, pose), "negative");
    expect_error(lit_triangle({{"type", "point"}, {"color", {1, 1}}}, pose), "color");
    expect_error(lit_triangle({{"type", "point"}, {"intensity", 1e38}, {"color", {10, 1, 1}}}, pose),
                 "not finite");
    expect_error(lit_triangle({{"type", "directional"}}, {{"scale", {1, 1, 0}}}), "direction");
    GltfFile dangling = lit_triangle({{"type", "point"}}, pose);
    dangling.node(1)["extensions"]["KHR_lights_punctual"]["light"] = 1;
    expect_error(dangling, "light is 1");
}

// ---- Cameras ----

TEST_F(LoadGltfCameras, ReadsPerspectiveCamerasWithoutScale) {
    GltfFile file = one_triangle();
    const double half = std::numbers::sqrt2 / 2;
    file.document["cameras"] = {
        {{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    file.document["nodes"].push_back(
        {{"camera", 0}, {"rotation", {0, half, 0, half}}, {"scale", {2, 3, 4}}, {"translation", {1, 2, 3}}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(file);
    ASSERT_EQ(scene.camera.size(), 1u);
    EXPECT_EQ(scene.camera[0].name, "eye");
    EXPECT_EQ(scene.camera[0].eye, Vec3(1, 2, 3));
    // A quarter turn about y makes -z into -x.
    expect_near(scene.camera[0].forward, {-1, 0, 0});
    expect_near(scene.camera[0].up, {0, 1, 0});
    EXPECT_FLOAT_EQ(scene.camera[0].vertical_fov, 0.5f);
}

TEST_F(LoadGltfCameras, LeavesOutOrthographicCameras) {
    GltfFile file = one_triangle();
    file.document["cameras"] = {
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}}};
    file.node()["camera"] = 0;
    const Scene scene = load(file);
    EXPECT_TRUE(scene.camera.empty());
    EXPECT_TRUE(has_warning(scene, "orthographic"));
}

TEST_F(LoadGltfCameras, RefusesImpossibleFieldsOfView) {
    GltfFile file = one_triangle();
    file.node()["camera"] = 0;
    for (const double yfov : {0.0, -1.0, 3.2}) {
        file.document["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", 1}}}}};
        expect_error(file, "field of view");
    }
}

// ---- Files that are refused ----

TEST_F(LoadGltfErrors, MissingFile) {
    expect_error(directory.path() / "none.gltf", "does not exist");
    expect_error(directory.path(), "is not a file");
}

TEST_F(LoadGltfErrors, NotGltf) {
    expect_error(directory.write("empty.gltf", std::string()), "not glTF");
    expect_error(directory.write("text.gltf", std::string("{\"asset\"")), "not glTF");
    expect_error(directory.write("list.gltf", std::string("[1, 2, 3]")), "not glTF");
    expect_error(directory.write("deep.gltf", std::string(100000, '[')), "nested");
    expect_error(directory.write("huge.gltf", std::string(R"({"asset": {"version": "2.0"}, "x": 1e999})")),
                 "not glTF");
}

TEST_F(LoadGltfErrors, OtherVersions) {
    GltfFile file = one_triangle();
    file.document["asset"] = {{"version", "1.0"}};
    expect_error(file, "glTF 1.0");
    file.document["asset"] = {{"version", "2.1"}, {"minVersion", "2.1"}};
    expect_error(file, "2.1");
    file.document["asset"] = {{"version", "two"}};
    expect_error(file, "asset/version");
    file.document.erase("asset");
    expect_error(file, "asset/version");
}

TEST_F(LoadGltfErrors, TruncatedGlbAtEveryLength) {
    const Bytes whole = one_triangle().glb();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::filesystem::path file = directory.write("cut.glb", std::span(whole).first(size));
        EXPECT_NE(error_of(file), "loaded") << size;
    }
    expect_error(directory.write("cut.glb", std::span(whole).first(whole.size() - 1)), "truncated");
}

TEST_F(LoadGltfErrors, GlbWithWrongHeader) {
    const Bytes whole = one_triangle().glb();
    const auto with = [&](std::size_t place, std::uint8_t value) {
        Bytes bytes = whole;
        bytes[place] = value;
        return directory.write("bad.glb", bytes);
    };
    expect_error(with(0, 'x'), "not glTF");
    expect_error(with(4, 1), "version 1");
    expect_error(with(8, 0), "");
    expect_error(with(15, 0xFF), "truncated");
    expect_error(with(16, 'x'), "not JSON");
}

TEST_F(LoadGltfErrors, NoTriangles) {
    GltfFile file = one_triangle();
    file.node().erase("mesh");
    expect_error(file, "has no triangles");
    file.document = {{"asset", {{"version", "2.0"}}}};
    expect_error(file, "has no triangles");
}

TEST_F(LoadGltfErrors, UnknownRequiredExtension) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    EXPECT_TRUE(has_warning(load(file), "KHR_draco_mesh_compression"));
    file.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    expect_error(file, "KHR_draco_mesh_compression");
    file.document["extensionsRequired"] = {"KHR_materials_clearcoat", "KHR_lights_punctual"};
    EXPECT_EQ(load(file).triangle.size(), 1u);
    file.document["extensionsRequired"] = 5;
    expect_error(file, "extensionsRequired");
}

TEST_F(LoadGltfErrors, MissingBuffer) {
    GltfFile file = one_triangle();
    file.document["buffers"] = {{{"byteLength", 36}, {"uri", "none.bin"}}};
    expect_error(file, "none.bin");
    file.document["buffers"] = {{{"byteLength", 36}}};
    expect_error(file, "buffers/0");
    file.document["buffers"] = {{{"byteLength", 36}, {"uri", "data:application/octet-stream;base64,!"}}};
    expect_error(file, "uri");
}

TEST_F(LoadGltfErrors, RangesBeyondTheirTarget) {
    constexpr std::uint64_t huge = std::numeric_limits<std::uint64_t>::max();
    // The positions are the first 36 of 60 bytes.
    expect_change_refused("/bufferViews/0/byteLength", 61, "bufferViews/0");
    expect_change_refused("/bufferViews/0/byteOffset", 25, "bufferViews/0");
    expect_change_refused("/bufferViews/0/byteOffset", huge - 10, "bufferViews/0");
    expect_change_refused("/bufferViews/0/byteOffset", -4, "bufferViews/0/byteOffset");
    expect_change_refused("/bufferViews/0/byteStride", 4, "byteStride");
    expect_change_refused("/bufferViews/0/byteStride", 16, "accessors/0 goes beyond");
    expect_change_refused("/accessors/0/count", 4, "accessors/0 goes beyond");
    expect_change_refused("/accessors/0/count", 0, "accessors/0 is empty");
    expect_change_refused("/accessors/0/count", huge, "32 bits");
    expect_change_refused("/accessors/0/count", 4294967295u, "accessors/0 goes beyond");
    expect_change_refused("/accessors/0/byteOffset", 4, "accessors/0 goes beyond");
    expect_change_refused("/accessors/0/byteOffset", huge - 3, "accessors/0 goes beyond");
}

TEST_F(LoadGltfErrors, MoreZerosThanAnyFileNeeds) {
    GltfFile file = one_triangle();
    file.accessor(0).erase("bufferView");
    file.accessor(0)["count"] = 4000000000u;
    expect_error(file, "no data");
}

TEST_F(LoadGltfErrors, SparseRangesBeyondTheirTarget) {
    GltfFile file = one_triangle();
    const int indices = file.add_view(bytes_of<std::uint8_t>({3}));
    const int values = file.add_view(bytes_of<float>({5, 0, 0}));
    const Json sparse = {{"count", 1},
                         {"indices", {{"bufferView", indices}, {"componentType", u8}}},
                         {"values", {{"bufferView", values}}}};
    file.accessor(0)["sparse"] = sparse;
    expect_error(file, "sparse index");
    file.accessor(0)["sparse"]["count"] = 2;
    expect_error(file, "sparse/indices");
    file.accessor(0)["sparse"] = sparse;
    file.accessor(0)["sparse"]["indices"]["componentType"] = f32;
    expect_error(file, "sparse indices");
    file.accessor(0)["sparse"] = 7;
    expect_error(file, "accessors/0/sparse");
}

TEST_F(LoadGltfErrors, IndicesBeyondTheirLists) {
    expect_change_refused("/scene", 1, "scene is 1");
    expect_change_refused("/scene", -1, "scene");
    expect_change_refused("/scenes/0/nodes/0", 1, "nodes/0 is 1");
    expect_change_refused("/nodes/0/mesh", 1, "mesh is 1");
    expect_change_refused("/nodes/0/mesh", std::uint64_t{1} << 32, "mesh is 4294967296");
    expect_change_refused("/nodes/0/mesh", "0", "nodes/0/mesh");
    expect_change_refused("/nodes/0/children", {-1}, "children/0");
    expect_change_refused("/nodes/0/camera", 0, "camera is 0");
    expect_change_refused("/meshes/0/primitives/0/material", 1, "material is 1");
    expect_change_refused("/meshes/0/primitives/0/indices", 9, "indices is 9");
    expect_change_refused("/meshes/0/primitives/0/attributes/POSITION", 9, "POSITION is 9");
    expect_change_refused("/materials/0/normalTexture", {{"index", 1}}, "normalTexture/index is 1");
    expect_change_refused("/textures/0/sampler", 0, "sampler is 0");
    expect_change_refused("/bufferViews/0/buffer", 1, "buffer");
    expect_change_refused("/accessors/0/bufferView", 9, "bufferView is 9");
    expect_change_refused("/nodes", Json::object(), "nodes is not a list");
    expect_change_refused("/meshes/0/primitives/0", 5, "meshes/0/primitives/0 is not an object");
}

TEST_F(LoadGltfErrors, VertexIndexBeyondTheVertices) {
    GltfFile file = one_triangle();
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 3}, u8, "SCALAR");
    expect_error(file, "index 3");
}

TEST_F(LoadGltfErrors, AttributesOfDifferentLength) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["TEXCOORD_0"] = file.add_accessor<float>({0, 0, 1, 1}, f32, "VEC2");
    expect_error(file, "TEXCOORD_0 has 2");
}

TEST_F(LoadGltfErrors, WrongAttributeTypes) {
    GltfFile file = one_triangle();
    const int indices = file.add_accessor<std::uint32_t>({0, 1, 2}, u32, "SCALAR");
    const int vectors = file.add_accessor<std::uint32_t>({0, 0, 0, 1, 1, 1, 2, 2, 2}, u32, "VEC3");
    file.primitive()["attributes"]["POSITION"] = indices;
    expect_error(file, "VEC3");
    file.primitive()["attributes"]["POSITION"] = vectors;
    expect_error(file, "VEC3");
    file.primitive() = {{"attributes", {{"POSITION", 0}}}, {"indices", 0}};
    expect_error(file, "indices");
}

TEST_F(LoadGltfErrors, PositionsThatAreNotFinite) {
    for (const float bad : {nan_value, std::numeric_limits<float>::infinity(), 1e30f}) {
        GltfFile file = one_triangle();
        file.primitive()["attributes"]["POSITION"] =
            file.add_accessor<float>({0, 0, 0, bad, 0, 0, 0, 1, 0}, f32, "VEC3");
        expect_error(file, "position");
    }
}

TEST_F(LoadGltfErrors, WhatTinygltfDropsSilently) {
    GltfFile file = one_triangle();
    file.document["meshes"][0]["primitives"].push_back(Json::object());
    expect_error(file, "attributes");
}

}  // namespace
