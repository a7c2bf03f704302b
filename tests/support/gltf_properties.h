// A glTF file that has every kind of object, and the effect of changing one of its properties.
#pragma once

#include <sstream>
#include <utility>

#include "common/scene/fingerprint.h"
#include "tests/support/load_gltf.h"

namespace gltf_text {

enum class Treatment {
    drawn,    ///< the scene becomes another one, without a warning
    unseen,   ///< neither the scene nor its warnings change, as nothing visible depends on it
    warned,   ///< there is a warning with the words `said`
    refused,  ///< the file is refused with the words `said`
};

/// A property of a glTF object with a value that is not its default.
struct Property {
    std::string place;  ///< JSON pointer
    Json value;         ///< null to take it away
    Treatment treatment;
    std::string said = "";
    std::vector<std::pair<std::string, Json>> also = {};  ///< further changes that it needs
};

/// Makes a file with all objects of glTF 2.0 at least once that causes no warning. Scene 0 has two meshes, a
/// camera and three lights; mesh 1 has a skin. Node 7, which is mesh 0 again, is only in scene 1.
inline GltfFile file_of_everything(const TemporaryDirectory& directory) {
    GltfFile file = one_triangle();
    // Accessors 1 to 13, each with a buffer view of the same number.
    const int normal = file.add_accessor<float>({0, 1, 1, 1, 0, 1, 0, 0, 1}, f32, "VEC3");
    const int tangent = file.add_accessor<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, f32, "VEC4");
    const int texcoord0 = file.add_accessor<std::uint16_t>({0, 0, 65535, 0, 0, 30000}, u16, "VEC2");
    const int texcoord1 = file.add_accessor<float>({0, 0, 0.5f, 0, 0, 0.5f}, f32, "VEC2");
    const int indices = file.add_accessor<std::uint16_t>({1, 2, 0, 0, 2, 1}, u16, "SCALAR");
    file.add_accessor<float>({0, 1, 2, 0, 1, 3, 0, 1, 4}, f32, "VEC3");  // 6: a change
    const int joints = file.add_accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, u8, "VEC4");
    const int weights =
        file.add_accessor<float>({1, 0, 0, 0, 0.75f, 0.25f, 0, 0, 0.5f, 0.5f, 0, 0}, f32, "VEC4");
    std::vector<float> bind;
    for (int joint = 0; joint < 2; ++joint)
        bind.insert(bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1});
    const int bind_matrices = file.add_accessor<float>(bind, f32, "SCALAR");
    file.add_accessor<std::uint8_t>(Bytes(12, 1), u8, "VEC4");                    // 10: other joints
    file.add_accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, f32, "VEC4");  // 11: other weights
    file.add_accessor<float>({0, 1, 0, 1, 0, 1}, f32, "VEC2");                    // 12: a change
    file.add_accessor<float>({1, 2, 1, 2, 1, 1, 1, 1, 2}, f32, "VEC3");           // 13: scales
    file.accessor(texcoord0)["normalized"] = true;
    file.accessor(indices)["count"] = 3;
    file.accessor(bind_matrices).update({{"type", "MAT4"}, {"count", 2}});
    // Buffer views 14 to 16.
    const int places = file.add_view({1, 2, 1});
    const int values = file.add_view(bytes_of<float>({4, 1, 0, 0, 5, 1}));
    file.add_view(sixteen_bit_png());
    file.accessor(0)["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", places}, {"byteOffset", 0}, {"componentType", u8}}},
        {"values", {{"bufferView", values}, {"byteOffset", 0}}}};

    const Json textured = {{"POSITION", 0},
                           {"NORMAL", normal},
                           {"TANGENT", tangent},
                           {"TEXCOORD_0", texcoord0},
                           {"TEXCOORD_1", texcoord1}};
    const Json skinned = {{"POSITION", 0}, {"NORMAL", normal}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}};
    file.document["meshes"] = {{{"primitives",
                                 {{{"attributes", textured},
                                   {"indices", indices},
                                   {"material", 0},
                                   {"targets", Json::array({Json::object()})}}}}},
                               {{"primitives", {{{"attributes", skinned}, {"material", 1}}}}}};
    file.document["nodes"] = {
        {{"mesh", 0}},
        {{"mesh", 1}, {"skin", 0}, {"translation", {0, 0, 7}}},  // ignored because of the skin
        {{"translation", {0, 0, 2.5}}},
        {{"camera", 0}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 2}}}}}},
        {{"mesh", 0}, {"translation", {0, 0, 9}}}};
    file.document["scenes"] = {{{"nodes", {0, 1, 2, 3, 4, 5, 6}}}, {{"nodes", {7}}}};
    file.document["skins"] = {{{"joints", {2, 3}}, {"inverseBindMatrices", bind_matrices}}};
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    file.document["extensionsUsed"] = {"KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}}}},
        {{"type", "directional"}}};
    file.document["materials"] = {{{"pbrMetallicRoughness",
                                    {{"metallicFactor", 0},
                                     {"baseColorFactor", {0.5, 0.5, 0.5, 1}},
                                     {"baseColorTexture", {{"index", 0}}}}},
                                   {"normalTexture", {{"index", 0}}},
                                   {"emissiveTexture", {{"index", 0}}},
                                   {"emissiveFactor", {1, 1, 1}}},
                                  {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}}};
    file.document["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}, {"sampler", 0}}};
    file.document["images"] = {{{"uri", "red green.png"}}, {{"uri", "other.png"}}};
    file.document["samplers"] = {{{"wrapS", 33648}, {"wrapT", 33648}}};
    Bytes other = file.buffer;
    for (std::size_t i = 0; i < 36; i += 4) other[i] = 1;  // the positions a little elsewhere
    directory.write("other.bin", other);
    directory.write("red green.png", red_green_png());
    directory.write("other.png", sixteen_bit_png());
    file.document["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "data.bin"}},
                                {{"byteLength", file.buffer.size()}, {"uri", "other.bin"}}};
    return file;
}

/// Returns everything in a scene that its images depend on, which excludes names.
inline std::string description(const Scene& scene) {
    std::ostringstream text;
    text << common::fingerprint(scene);
    for (const common::Camera& camera : scene.camera)
        text << ' ' << camera.eye << camera.forward << camera.up << camera.vertical_fov;
    return text.str();
}

class GltfProperties : public LoadGltf {
  protected:
    /// Changes the properties one by one and compares the result with the expected treatment.
    void check(const std::vector<Property>& properties) const {
        const Scene whole = load(file_of_everything(directory));
        EXPECT_EQ(whole.warnings, std::vector<std::string>());
        for (const Property& property : properties) {
            SCOPED_TRACE(property.place + " = " + property.value.dump());
            GltfFile file = file_of_everything(directory);
            change(file.document, property.place, property.value);
            for (const auto& [place, value] : property.also) change(file.document, place, value);
            if (property.treatment == Treatment::refused) {
                expect_error(file, property.said);
            } else {
                check_loaded(file, property, description(whole));
            }
        }
    }

  private:
    static void change(Json& document, const std::string& place, const Json& value) {
        const Json::json_pointer pointer(place);
        if (value.is_null()) {
            document[pointer.parent_pointer()].erase(pointer.back());
        } else {
            document[pointer] = value;
        }
    }

    void check_loaded(const GltfFile& file, const Property& property, const std::string& whole) const {
        const std::filesystem::path path = file.write(directory);
        const std::string error = error_of(path);
        ASSERT_EQ(error, "loaded");
        const Scene scene = common::load_gltf(path);
        if (property.treatment == Treatment::warned) {
            EXPECT_TRUE(has_warning(scene, property.said)) << testing::PrintToString(scene.warnings);
            return;
        }
        EXPECT_EQ(scene.warnings, std::vector<std::string>());
        if (property.treatment == Treatment::drawn) {
            EXPECT_NE(description(scene), whole);
        } else {
            EXPECT_EQ(description(scene), whole);
        }
    }
};

}  // namespace gltf_text
