// glTF loader: files that are refused, and the words of the error.
#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

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
    file.document["extensionsRequired"] = {"KHR_materials_unlit", "KHR_lights_punctual"};
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
