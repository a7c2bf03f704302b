// glTF loader: sources of the bytes, and their compression.
#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

using LoadGltfFiles = LoadGltf;
using LoadGltfCompression = LoadGltf;
using LoadGltfExtensions = LoadGltf;

// ---- URIs ----

TEST_F(LoadGltfFiles, AreFoundByWhatTheirUriStandsFor) {
    std::filesystem::create_directory(directory.path() / "sub");
    const std::vector<std::pair<std::string, std::string>> names = {{"wood+oak.bin", "wood+oak.bin"},
                                                                    {"wood%2Bash.bin", "wood+ash.bin"},
                                                                    {"room%20a.bin", "room a.bin"},
                                                                    {"room b.bin", "room b.bin"},
                                                                    {"caf%C3%A9.bin", "caf\xC3\xA9.bin"},
                                                                    {"\xE6\x9C\xA8.bin", "\xE6\x9C\xA8.bin"},
                                                                    {"a%23b.bin", "a#b.bin"},
                                                                    {"c#d.bin", "c#d.bin"},
                                                                    {"100%25.bin", "100%.bin"},
                                                                    {"100%.bin", "100%.bin"},
                                                                    {"example 10%.bin", "example 10%.bin"},
                                                                    {"50%2525.bin", "50%25.bin"},
                                                                    {"sub/x%2e%62in", "sub/x.bin"},
                                                                    {"./sub/../y.bin", "y.bin"},
                                                                    {"what?.bin", "what?.bin"},
                                                                    {"%", "%"}};
    for (const auto& [uri, name] : names) {
        GltfFile file = one_triangle();
        directory.write(name, file.buffer);
        file.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        EXPECT_EQ(load(file).triangle.size(), 1u) << uri;

        file = textured_triangle();
        directory.write(name, red_green_png());
        file.document["images"][0]["uri"] = uri;
        file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        EXPECT_EQ(load(file).texture.size(), 1u) << uri;
    }
}

TEST_F(LoadGltfFiles, AreRefusedByNameWhereTheyAreNotToBeRead) {
    GltfFile file = one_triangle();
    const auto with = [&](const std::string& uri) {
        file.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        return file;
    };
    expect_error(with("wood%20oak.bin"), "buffers/0: 'wood oak.bin' does not exist");
    expect_error(with("https://example.com/x.bin"), "'https://example.com/x.bin' does not exist");
    expect_error(with(""), "is not a file");
    expect_error(with("/dev/null"), "is not a file");
    directory.write("short.bin", Bytes(35));
    expect_error(with("short.bin"), "buffers/0 has 35 of its 36 bytes");
    file.document["buffers"][0].erase("byteLength");
    file.accessor(0).erase("bufferView");
    file.document.erase("bufferViews");
    expect_error(file, "buffers/0 has no byteLength");
}

// ---- Data URIs ----

// Nine floats: 0 0 0  1 0 0  0 1 0.
const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

TEST_F(LoadGltfFiles, CanBeDataUrisOfAnyTypeAndLength) {
    GltfFile file = one_triangle();
    for (const std::string& uri :
         {"data:application/octet-stream;base64," + base64, "data:application/gltf-buffer;base64," + base64,
          "data:;base64," + base64, "data:application/octet-stream;charset=x;base64," + base64,
          "data:application/octet-stream;base64," + base64 + "AAAA",
          "data:application/octet-stream;base64," + base64 + "AA==",
          "data:application/octet-stream;base64," + base64 + "AAA%3D",
          std::string("data:application/octet-stream,") +
              "%00%00%00%00%00%00%00%00%00%00%00%00%00%00%80%3f%00%00%00%00" +
              "%00%00%00%00%00%00%00%00%00%00%80%3F%00%00%00%00"}) {
        file.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        EXPECT_EQ(triangles_of(load(file))[0][2], Vec3(0, 1, 0)) << uri;
    }
}

TEST_F(LoadGltfFiles, AreRefusedAsDataUrisWithoutTheirData) {
    GltfFile file = one_triangle();
    const auto expect_uri_refused = [&](const std::string& uri, const std::string& part) {
        file.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        expect_error(file, part);
    };
    expect_uri_refused("data:application/octet-stream;base64," + base64.substr(4), "has 33 of its 36 bytes");
    expect_uri_refused("data:application/octet-stream;base64,*" + base64, "not base64");
    expect_uri_refused("data:application/octet-stream;base64", "without data");
    const std::string error = [&] {
        file.document["buffers"] = {{{"byteLength", 3600}, {"uri", "data:;base64," + base64 + base64}}};
        return error_of(file.write(directory));
    }();
    EXPECT_EQ(error.find(base64), std::string::npos) << "the data is nothing to read: " << error;
}

// ---- Containers ----

TEST_F(LoadGltfFiles, CanHaveAMarkBeforeAndPaddingBehindThem) {
    const GltfFile triangle = one_triangle();
    Json text = triangle.document;
    text["buffers"] = {{{"byteLength", 36}, {"uri", "data.bin"}}};
    directory.write("data.bin", triangle.buffer);
    EXPECT_EQ(common::load_gltf(directory.write("mark.gltf", "\xEF\xBB\xBF" + text.dump())).triangle.size(),
              1u);

    Bytes glb = triangle.glb();
    glb.insert(glb.end(), {'m', 'o', 'r', 'e'});
    EXPECT_EQ(common::load_gltf(directory.write("behind.glb", glb)).triangle.size(), 1u);

    GltfFile longer = triangle;
    longer.document["buffers"] = {{{"byteLength", 36}}};
    Bytes bytes = longer.buffer;
    bytes.resize(44);
    EXPECT_EQ(common::load_gltf(
                  directory.write("longer.glb", common::gltf::make_glb(longer.document.dump(), bytes)))
                  .triangle.size(),
              1u);
}

TEST_F(LoadGltfFiles, HaveOneBinaryChunkForTheFirstBufferOnly) {
    GltfFile file = one_triangle();
    file.document["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 36}}};
    file.document["bufferViews"][0]["buffer"] = 1;
    expect_error(directory.write("two.glb", common::gltf::make_glb(file.document.dump(), file.buffer)),
                 "buffers/1 has no data");
    file.document["buffers"][1]["uri"] = "data.bin";
    directory.write("data.bin", file.buffer);
    EXPECT_EQ(
        common::load_gltf(directory.write("two.glb", common::gltf::make_glb(file.document.dump(), Bytes(36))))
            .triangle.size(),
        1u);
}

TEST_F(LoadGltfFiles, CanHaveIndicesThatAreSparseAlone) {
    GltfFile file = one_triangle();
    const int places = file.add_view(bytes_of<std::uint8_t>({1, 2}));
    const int values = file.add_view(bytes_of<std::uint16_t>({2, 1}));
    file.document["accessors"].push_back({{"componentType", u16},
                                          {"count", 3},
                                          {"type", "SCALAR"},
                                          {"sparse",
                                           {{"count", 2},
                                            {"indices", {{"bufferView", places}, {"componentType", u8}}},
                                            {"values", {{"bufferView", values}}}}}});
    file.primitive()["indices"] = 1;
    EXPECT_EQ(load(file).geometric_normal[0], Vec3(0, 0, -1));
}

TEST_F(LoadGltfFiles, CanHaveAFirstAndALastWordOnASparseElement) {
    GltfFile file = one_triangle();
    const int places = file.add_view(bytes_of<std::uint8_t>({2, 1, 2}));
    const int values = file.add_view(bytes_of<float>({9, 9, 9, 5, 0, 0, 0, 6, 0}));
    file.accessor(0)["sparse"] = {{"count", 3},
                                  {"indices", {{"bufferView", places}, {"componentType", u8}}},
                                  {"values", {{"bufferView", values}}}};
    EXPECT_EQ(triangles_of(load(file))[0], (std::array<Vec3, 3>{Vec3(0), Vec3(5, 0, 0), Vec3(0, 6, 0)}));
}

// ---- Compression ----

GltfFile draco_triangle() {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 2}, u8, "SCALAR");
    const int compressed = file.add_view(Bytes(40));
    file.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", compressed},
                                                                    {"attributes", {{"POSITION", 0}}}};
    return file;
}

TEST_F(LoadGltfCompression, IsNamedWhereDracoIsAllThereIs) {
    for (const int without : {0, 1}) {
        GltfFile file = draco_triangle();
        file.accessor(without).erase("bufferView");
        expect_error(file, "compressed with KHR_draco_mesh_compression");
    }
    GltfFile file = draco_triangle();
    file.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    expect_error(file, "requires the extension KHR_draco_mesh_compression");
}

TEST_F(LoadGltfCompression, LeavesDracosFallbackToBeRead) {
    const Scene scene = load(draco_triangle());
    EXPECT_EQ(scene.triangle.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "KHR_draco_mesh_compression ignored: meshes/0/primitives/0"));
}

TEST_F(LoadGltfCompression, IsNamedWhereMeshoptIsAllThereIs) {
    for (const char* name :
         {"EXT_meshopt_compression", "KHR_meshopt_compression", "MESHOPT_compression_of_tomorrow"}) {
        const bool is_known = std::string(name).ends_with("meshopt_compression");
        GltfFile file = one_triangle();
        file.document["extensionsUsed"] = {name};
        file.document["buffers"] = {{{"byteLength", 36}, {"uri", "data.bin"}}, {{"byteLength", 36}}};
        file.view(0) = {
            {"buffer", 1},
            {"byteLength", 36},
            {"extensions", {{name, {{"buffer", 0}, {"byteLength", 36}, {"mode", "ATTRIBUTES"}}}}}};
        expect_error(file, is_known ? name : "buffers/1 has no data");
        file.document["buffers"][1]["extensions"][name]["fallback"] = true;
        expect_error(file, is_known ? name : "buffers/1 has no data");
        file.document["buffers"][1]["uri"] = "data.bin";
        const Scene scene = load(file);
        EXPECT_EQ(scene.triangle.size(), 1u) << "its fallback";
        EXPECT_TRUE(has_warning(scene, std::string("extension ") + name + " ignored"));
    }
}

TEST_F(LoadGltfCompression, IsNamedWhereATextureHasNoOtherImage) {
    for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp"}) {
        GltfFile file = textured_triangle();
        file.document["extensionsUsed"] = {name};
        file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        file.document["textures"][0] = {{"extensions", {{name, {{"source", 0}}}}}};
        expect_error(file, name);
        file.document["textures"][0]["source"] = 0;
        directory.write("red green.png", red_green_png());
        EXPECT_EQ(load(file).texture.size(), 1u) << "its fallback";
    }
}

TEST_F(LoadGltfCompression, IsNamedWhereAnImageIsNoPngOrJpeg) {
    const std::vector<std::pair<std::string, std::string>> formats = {
        {std::string("RIFF\x14\0\0\0WEBPVP8L", 16), "WebP"},
        {"\xABKTX 20\xBB\r\n\x1A\n", "KTX2"},
        {"DDS |", "DDS"},
        {std::string("\0\0\0\x1C"
                     "ftypavif",
                     12),
         "AVIF"},
        {"sB", "Basis"},
        {"<svg xmlns=", "SVG"},
        {"", "cannot be read"},
        {"R", "cannot be decoded as PNG or JPEG"}};
    for (const auto& [bytes, name] : formats) {
        directory.write("red green.png", bytes);
        GltfFile file = textured_triangle();
        file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        expect_error(file, name);
        expect_error(file, "'red green.png'");
    }
}

// ---- Extensions ----

TEST_F(LoadGltfExtensions, ThatAreNotDrawnAreEachNamedOnce) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"VENDOR_one", "VENDOR_two"};
    const Json cleared = {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}},
               dielectric = {{"metallicFactor", 0}};
    file.document["materials"] = {{{"extensions", cleared}, {"pbrMetallicRoughness", dielectric}},
                                  {{"extensions", cleared}, {"pbrMetallicRoughness", dielectric}}};
    file.document["extensions"]["VENDOR_two"] = Json::object();
    file.document["extras"]["extensions"]["VENDOR_of_something_else"] = Json::object();
    const Scene scene = load(file);
    ASSERT_EQ(scene.warnings.size(), 3u) << testing::PrintToString(scene.warnings);
    EXPECT_TRUE(has_warning(scene, "extension VENDOR_one ignored: extensionsUsed"));
    EXPECT_TRUE(has_warning(scene, "extension VENDOR_two ignored: the file"));
    EXPECT_TRUE(has_warning(scene, "KHR_materials_clearcoat not drawn: materials/0 and 1 more"))
        << "used, but not listed";
}

TEST_F(LoadGltfExtensions, ThatAreNotDrawnAreRefusedWhereTheFileRequiresThem) {
    GltfFile file = one_triangle();
    for (const char* name : {"KHR_materials_clearcoat", "KHR_texture_basisu", "VENDOR_one"}) {
        file.document["extensionsRequired"] = {"KHR_lights_punctual", name};
        expect_error(file, std::string("requires the extension ") + name);
    }
}

TEST_F(LoadGltfExtensions, ThatChangeNothingAreNotMentioned) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_xmp_json_ld", "KHR_animation_pointer", "KHR_mesh_quantization"};
    file.document["extensionsRequired"] = file.document["extensionsUsed"];
    EXPECT_TRUE(load(file).warnings.empty());
}

TEST_F(LoadGltfExtensions, OfferingAChoiceAreDrawnWithoutOne) {
    GltfFile file = one_triangle();
    file.document["extensionsRequired"] = {"KHR_materials_variants"};
    file.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = Json::array();
    EXPECT_TRUE(has_warning(load(file), "KHR_materials_variants"));
}

TEST_F(LoadGltfExtensions, HaveNumbersOfAnySize) {
    for (const double strength : {3e9, -3e9, 3000000000.5, 1e19, 7.0}) {
        GltfFile file = one_triangle();
        file.material()["emissiveFactor"] = {1, 1, 1};
        Json& extension = file.material()["extensions"]["KHR_materials_emissive_strength"];
        extension["emissiveStrength"] = strength;
        const Rgb expected = Rgb(std::max(static_cast<float>(strength), 0.0f));
        EXPECT_EQ(load(file).material[0].emitted_radiance, expected);
        if (strength != std::floor(strength) || strength < 0) continue;
        extension["emissiveStrength"] = static_cast<std::uint64_t>(strength);
        EXPECT_EQ(load(file).material[0].emitted_radiance, expected) << "as a whole number";
    }
}

TEST_F(LoadGltfExtensions, AnimationsAreNamedAsNotPlayed) {
    GltfFile file = one_triangle();
    file.document["animations"] = {{{"name", "walk"}}, {{"channels", 7}}};
    EXPECT_TRUE(has_warning(load(file), "animations not played: 'walk' and 1 more"));
    file.document["animations"] = {Json::object()};
    EXPECT_TRUE(has_warning(load(file), "animations not played: animations/0"));
}

}  // namespace
