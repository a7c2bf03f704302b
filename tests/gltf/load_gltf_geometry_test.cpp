// glTF loader: triangles, vertices and node transforms.

#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

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

/// Makes the four corners of the unit square, in the order of a strip.
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
    // Rows of two bytes, padded to four.
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
    // The bitangent in the file is +y and must remain so.
    expect_near(scene.normal[0].cross(scene.tangent[0]) * scene.tangent_sign[0], {0, 1, 0});
}

TEST_F(LoadGltfNodes, MakesAnInstanceOfEveryPrimitiveUnderEveryNode) {
    GltfFile file = one_triangle();
    file.document["meshes"][0]["name"] = "mesh";
    Json elsewhere = file.primitive();
    elsewhere["attributes"]["POSITION"] = file.add_accessor<float>({0, 0, 5, 1, 0, 5, 0, 1, 5}, f32, "VEC3");
    file.document["meshes"][0]["primitives"].push_back(elsewhere);
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
    file.document["nodes"] = {{{"mesh", 0}, {"children", {1}}},
                              {{"mesh", 0}, {"translation", {2, 0, 0}}},
                              {{"mesh", 0}, {"translation", {4, 0, 0}}}};
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

}  // namespace
