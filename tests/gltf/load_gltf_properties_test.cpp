// Tests every property of glTF 2.0 and of the ratified extensions of Khronos. Each one is drawn, has no
// visible effect, causes a warning, or makes the file refused. None is ignored silently.
//
// Sources: the "Properties Reference" of the glTF 2.0 specification, section 5, in its order, and the
// extensions' own specifications.
#include "tests/support/gltf_properties.h"

namespace {

using namespace gltf_text;
using enum Treatment;

const Json anything = {{"anything", {1, 2}}};

TEST_F(GltfProperties, Accessors) {
    check({{"/accessors/0/bufferView", 1, drawn},
           {"/accessors/5/byteOffset", 6, drawn},
           {"/accessors/3/componentType", i16, drawn},
           {"/accessors/3/normalized", false, drawn},
           {"/accessors/5/count", 6, drawn},
           {"/accessors/0/type", "VEC2", refused, "VEC3"},
           {"/accessors/0/max", {9, 9, 9}, unseen},
           {"/accessors/0/min", {9, 9, 9}, unseen},
           {"/accessors/0/sparse", nullptr, drawn},
           {"/accessors/0/sparse/count", 2, drawn},
           {"/accessors/0/sparse/indices/bufferView", 15, drawn},
           {"/accessors/0/sparse/indices/byteOffset", 1, drawn},
           {"/accessors/0/sparse/indices/componentType", u16, refused, "sparse index"},
           {"/accessors/0/sparse/values/bufferView", 1, drawn},
           {"/accessors/0/sparse/values/byteOffset", 12, drawn},
           {"/accessors/0/name", "n", unseen},
           {"/accessors/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, Animations) {
    const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}};
    const Json sampler = {{"input", 0}, {"output", 0}, {"interpolation", "STEP"}};
    const Json animation = {
        {"name", "walk"}, {"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}};
    check({{"/animations", Json::array({animation}), warned, "animations not played: 'walk'"}});
}

TEST_F(GltfProperties, Asset) {
    check({{"/asset/copyright", "c", unseen},
           {"/asset/generator", "g", unseen},
           {"/asset/version", "3.0", refused, "glTF 3.0"},
           {"/asset/minVersion", "2.1", refused, "2.1"},
           {"/asset/extras", anything, unseen}});
}

TEST_F(GltfProperties, BuffersAndTheirViews) {
    check({{"/buffers/0/uri", "other.bin", drawn},
           {"/buffers/0/byteLength", 40, refused, "goes beyond the end of its buffer"},
           {"/buffers/0/name", "n", unseen},
           {"/buffers/0/extras", anything, unseen},
           {"/bufferViews/0/buffer", 1, drawn},
           {"/bufferViews/0/byteOffset", 4, drawn},
           {"/bufferViews/0/byteLength", 35, refused, "goes beyond the end of bufferViews/0"},
           {"/bufferViews/0/byteStride", 16, drawn, "", {{"/bufferViews/0/byteLength", 48}}},
           {"/bufferViews/0/target", 34962, unseen},
           {"/bufferViews/0/name", "n", unseen},
           {"/bufferViews/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, Cameras) {
    const Json orthographic = {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}};
    // The picture's shape comes from the command, and it shows everything in front of the camera.
    check({{"/cameras/0/type",
            "orthographic",
            warned,
            "orthographic cameras left out",
            {{"/cameras/0/orthographic", orthographic}}},
           {"/cameras/0/perspective/yfov", 1, drawn},
           {"/cameras/0/perspective/aspectRatio", 3, unseen},
           {"/cameras/0/perspective/znear", 2, unseen},
           {"/cameras/0/perspective/zfar", 3, unseen},
           {"/cameras/0/name", "n", unseen},
           {"/cameras/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, ImagesSamplersAndTextures) {
    check({{"/images/0/uri", "other.png", drawn},
           {"/images/0", {{"bufferView", 16}, {"mimeType", "image/png"}}, drawn},
           {"/images/0/mimeType", "image/jpeg", unseen},
           {"/images/0/name", "n", unseen},
           {"/images/0/extras", anything, unseen},
           {"/samplers/0/magFilter", 9728, drawn},
           {"/samplers/0/magFilter", 9729, unseen},
           {"/samplers/0/minFilter", 9984, unseen},  // all are sampled at full size
           {"/samplers/0/wrapS", 33071, drawn},
           {"/samplers/0/wrapT", 33071, drawn},
           {"/samplers/0/name", "n", unseen},
           {"/samplers/0/extras", anything, unseen},
           {"/textures/0/source", 1, drawn},
           {"/textures/0/sampler", nullptr, drawn},
           {"/textures/0/name", "n", unseen},
           {"/textures/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, Materials) {
    check({{"/materials/0/pbrMetallicRoughness/baseColorFactor", {0.5, 1, 0, 1}, drawn},
           {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 1, drawn},
           {"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", 1, drawn},
           {"/materials/0/normalTexture/index", 1, drawn},
           {"/materials/0/normalTexture/texCoord", 1, drawn},
           {"/materials/0/normalTexture/scale", 0.5, drawn},
           {"/materials/0/emissiveTexture/index", 1, drawn},
           {"/materials/0/emissiveTexture/texCoord", 1, drawn},
           {"/materials/0/emissiveTexture/texCoord", 2, warned, "TEXCOORD_2"},
           {"/materials/0/emissiveFactor", {1, 0, 0.5}, drawn},
           {"/materials/0/pbrMetallicRoughness/metallicFactor", nullptr, warned, "metal"},
           {"/materials/0/pbrMetallicRoughness/metallicFactor", 0.5, warned, "metal"},
           {"/materials/0/pbrMetallicRoughness/metallicFactor",
            1,
            drawn,
            "",
            {{"/materials/0/pbrMetallicRoughness/roughnessFactor", 0}}},
           {"/materials/0/pbrMetallicRoughness/roughnessFactor", 0.5, unseen},  // the gloss of non-metals
           {"/materials/0/pbrMetallicRoughness/metallicRoughnessTexture",
            {{"index", 0}},
            warned,
            "metal",
            {{"/materials/0/pbrMetallicRoughness/metallicFactor", 1}}},
           {"/materials/0/occlusionTexture", {{"index", 0}}, warned, "occlusionTexture"},
           {"/materials/0/alphaMode",
            "BLEND",
            drawn,
            "",
            {{"/materials/0/pbrMetallicRoughness/baseColorFactor", {0.5, 0.5, 0.5, 0.4}}}},
           {"/materials/0/alphaCutoff",
            0.3,
            drawn,
            "",
            {{"/materials/0/alphaMode", "MASK"},
             {"/materials/0/pbrMetallicRoughness/baseColorFactor", {0.5, 0.5, 0.5, 0.4}}}},
           {"/materials/0/doubleSided", true, drawn},
           {"/materials/0/name", "n", unseen},
           {"/materials/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, Meshes) {
    const std::string primitive = "/meshes/0/primitives/0/";
    const std::string attributes = primitive + "attributes/";
    const std::string skinned = "/meshes/1/primitives/0/attributes/";
    const std::vector<std::pair<std::string, Json>> weight = {{"/meshes/0/weights", {1}}};
    check({{attributes + "POSITION", 1, drawn},
           {attributes + "NORMAL", nullptr, drawn},
           {attributes + "TANGENT", nullptr, drawn},
           {attributes + "TEXCOORD_0", 4, drawn},
           {attributes + "TEXCOORD_1", 3, drawn},
           {attributes + "TEXCOORD_2", 3, unseen},
           {attributes + "COLOR_0", 2, drawn},
           {attributes + "COLOR_1", 2, warned, "COLOR_1 left out"},
           {attributes + "_OF_THE_APPLICATION", 0, unseen},
           {skinned + "JOINTS_0", 10, drawn},
           {skinned + "WEIGHTS_0", 11, drawn},
           {skinned + "JOINTS_1", 10, drawn, "", {{skinned + "WEIGHTS_1", 11}}},
           {primitive + "indices", nullptr, drawn},
           {primitive + "material", 1, drawn},
           {primitive + "mode", 6, drawn},
           {primitive + "mode", 0, warned, "points or lines left out"},
           {primitive + "targets/0/POSITION", 6, drawn, "", weight},
           {primitive + "targets/0/NORMAL", 6, drawn, "", weight},
           {primitive + "targets/0/TANGENT", 6, drawn, "", weight},
           {primitive + "targets/0/TEXCOORD_0", 12, drawn, "", weight},
           {primitive + "targets/0/TEXCOORD_1", 12, drawn, "", weight},
           {primitive + "targets/0/COLOR_0", 6, warned, "COLOR_0 of a morph target ignored", weight},
           {primitive + "targets/0/POSITION", 6, unseen, "", {{"/meshes/0/weights", {0}}}},
           {primitive + "extras", anything, unseen},
           {"/meshes/0/name", "n", unseen},
           {"/meshes/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, NodesAndScenes) {
    const Json moving = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1};
    check({{"/nodes/3/camera", nullptr, drawn},
           {"/nodes/0/children", {7}, drawn},
           {"/nodes/1/skin", nullptr, drawn},
           {"/nodes/0/matrix", moving, drawn},
           {"/nodes/0/mesh", nullptr, drawn},
           {"/nodes/0/rotation", {0, 0, 1, 0}, drawn},
           {"/nodes/0/scale", {1, 2, 1}, drawn},
           {"/nodes/0/translation", {1, 2, 3}, drawn},
           {"/nodes/0/weights", {1}, drawn, "", {{"/meshes/0/primitives/0/targets/0/POSITION", 6}}},
           {"/nodes/0/name", "n", unseen},
           {"/nodes/0/extras", anything, unseen},
           {"/scene", 1, drawn},
           {"/scenes/0/nodes", {0, 1, 2, 3}, drawn},
           {"/scenes/0/name", "n", unseen},
           {"/scenes/0/extras", anything, unseen},
           {"/extras", anything, unseen}});
}

TEST_F(GltfProperties, Skins) {
    check({{"/skins/0/inverseBindMatrices", nullptr, drawn},
           {"/skins/0/joints", {3, 2}, drawn},
           {"/skins/0/skeleton", 2, unseen},
           {"/skins/0/name", "n", unseen},
           {"/skins/0/extras", anything, unseen}});
}

TEST_F(GltfProperties, Lights) {
    const std::string lights = "/extensions/KHR_lights_punctual/lights/";
    check({{lights + "0/type", "directional", drawn},
           {lights + "0/color", {1, 0.5, 0}, drawn},
           {lights + "0/intensity", 2, drawn},
           {lights + "0/range", 2, warned, "range of a light ignored"},
           {lights + "0/name", "n", unseen},
           {lights + "0/extras", anything, unseen},
           {lights + "1/spot/innerConeAngle", 0.2, drawn},
           {lights + "1/spot/outerConeAngle", 0.3, drawn},
           {"/nodes/4/extensions/KHR_lights_punctual/light", 1, drawn}});
}

TEST_F(GltfProperties, ExtensionsOfMaterials) {
    const std::string of_material = "/materials/0/extensions/";
    const Json texture = {{"index", 0}};
    const std::vector<std::pair<std::string, Json>> not_drawn = {
        {"KHR_materials_anisotropy",
         {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 1}, {"anisotropyTexture", texture}}},
        {"KHR_materials_clearcoat",
         {{"clearcoatFactor", 1},
          {"clearcoatTexture", texture},
          {"clearcoatRoughnessFactor", 0.5},
          {"clearcoatRoughnessTexture", texture},
          {"clearcoatNormalTexture", texture}}},
        {"KHR_materials_diffuse_transmission",
         {{"diffuseTransmissionFactor", 0.5},
          {"diffuseTransmissionTexture", texture},
          {"diffuseTransmissionColorFactor", {1, 0.5, 0}},
          {"diffuseTransmissionColorTexture", texture}}},
        {"KHR_materials_dispersion", {{"dispersion", 1}}},
        {"KHR_materials_iridescence",
         {{"iridescenceFactor", 1},
          {"iridescenceTexture", texture},
          {"iridescenceIor", 1.5},
          {"iridescenceThicknessMinimum", 200},
          {"iridescenceThicknessMaximum", 300},
          {"iridescenceThicknessTexture", texture}}},
        {"KHR_materials_sheen",
         {{"sheenColorFactor", {1, 1, 1}},
          {"sheenColorTexture", texture},
          {"sheenRoughnessFactor", 0.5},
          {"sheenRoughnessTexture", texture}}},
        {"KHR_materials_specular",
         {{"specularFactor", 0.5},
          {"specularTexture", texture},
          {"specularColorFactor", {1, 0, 0}},
          {"specularColorTexture", texture}}},
    };
    for (const auto& [name, value] : not_drawn) {
        check({{of_material + name, value, warned, name + " not drawn: materials/0"},
               {"/extensionsUsed/1", name, unseen},
               {"/extensionsRequired", {name}, refused, name}});
    }
    const std::string transform =
        "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";
    const std::string glossy = of_material + "KHR_materials_pbrSpecularGlossiness/";
    const std::string glass = of_material + "KHR_materials_transmission/transmissionFactor";
    const std::string smooth = "/materials/0/pbrMetallicRoughness/roughnessFactor";
    check({{transform + "offset", {0.5, 0}, drawn},
           {transform + "rotation", 1, drawn},
           {transform + "scale", {2, 2}, drawn},
           {transform + "texCoord", 1, drawn},
           {"/materials/0/normalTexture/extensions/KHR_texture_transform/offset", {0.5, 0}, drawn},
           {"/materials/0/emissiveTexture/extensions/KHR_texture_transform/offset", {0.5, 0}, drawn},
           {glossy + "diffuseFactor", {1, 0, 0, 1}, drawn, "", {{glossy + "specularFactor", {0, 0, 0}}}},
           {glossy + "diffuseTexture", {{"index", 1}}, drawn, "", {{glossy + "specularFactor", {0, 0, 0}}}},
           {glossy + "specularFactor", {0.5, 0.5, 0.5}, warned, "specular part not drawn"},
           {glass, 1, drawn, "", {{smooth, 0}}},
           {glass, 1, warned, "rough transmission"},
           {glass, 0.8, warned, "partial", {{smooth, 0}}},
           {glass, 0.3, warned, "less than one half"},
           {of_material + "KHR_materials_volume/thicknessFactor", 1, drawn, "", {{glass, 1}, {smooth, 0}}},
           {of_material + "KHR_materials_volume/attenuationDistance",
            1,
            warned,
            "absorption",
            {{glass, 1}, {smooth, 0}, {of_material + "KHR_materials_volume/attenuationColor", {1, 0, 0}}}},
           {of_material + "KHR_materials_volume/thicknessTexture",
            texture,
            warned,
            "thicknessTexture",
            {{glass, 1}, {smooth, 0}}},
           {of_material + "KHR_materials_ior/ior", 1.4, drawn, "", {{glass, 1}, {smooth, 0}}},
           {of_material + "KHR_materials_ior/ior", 1.4, warned, "drawn on glass only"},
           {of_material + "KHR_materials_emissive_strength/emissiveStrength", 3, drawn},
           {of_material + "KHR_materials_unlit", Json::object(), warned, "unlit"},
           {"/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings", Json::array(), warned,
            "KHR_materials_variants"}});
}

TEST_F(GltfProperties, ExtensionsOfOtherObjects) {
    const Json instancing = {{"attributes", {{"TRANSLATION", 6}}}};
    const Json rotating = {{"attributes", {{"ROTATION", 8}}}};
    check({{"/nodes/0/extensions/EXT_mesh_gpu_instancing", instancing, drawn},
           {"/nodes/0/extensions/EXT_mesh_gpu_instancing", rotating, drawn},
           {"/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE", 13, drawn},
           {"/nodes/0/extensions/KHR_node_visibility/visible", false, drawn},
           {"/nodes/0/extensions/KHR_node_visibility/visible", true, unseen},
           {"/nodes/0/extensions/KHR_node_hoverability/hoverable", false, unseen},
           {"/nodes/0/extensions/KHR_node_selectability/selectable", false, unseen},
           {"/nodes/0/extensions/MSFT_lod/ids", {7}, warned, "MSFT_lod"},
           {"/scenes/0/extensions/EXT_lights_image_based/light", 0, warned, "EXT_lights_image_based"},
           {"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression",
            {{"bufferView", 0}},
            warned,
            "KHR_draco_mesh_compression ignored"},
           {"/bufferViews/0/extensions/EXT_meshopt_compression",
            {{"buffer", 0}},
            warned,
            "EXT_meshopt_compression ignored"},
           {"/bufferViews/0/extensions/KHR_meshopt_compression",
            {{"buffer", 0}},
            warned,
            "KHR_meshopt_compression ignored"},
           {"/textures/0/extensions/KHR_texture_basisu/source", 1, warned, "KHR_texture_basisu ignored"},
           {"/textures/0/extensions/EXT_texture_webp/source", 1, warned, "EXT_texture_webp ignored"},
           {"/asset/extensions/KHR_xmp_json_ld/packet", 0, unseen},
           {"/extensions/KHR_xmp_json_ld/packets", Json::array({Json::object()}), unseen},
           {"/extensionsUsed/1", "KHR_mesh_quantization", unseen},
           {"/extensionsUsed/1", "KHR_animation_pointer", unseen},
           {"/extensionsUsed/1", "VENDOR_anything", warned, "VENDOR_anything ignored"},
           {"/extensionsRequired", {"EXT_mesh_gpu_instancing", "KHR_mesh_quantization"}, unseen},
           {"/extensionsRequired", {"KHR_draco_mesh_compression"}, refused, "KHR_draco_mesh_compression"},
           {"/extensionsRequired", {"EXT_meshopt_compression"}, refused, "EXT_meshopt_compression"},
           {"/extensionsRequired", {"KHR_texture_basisu"}, refused, "KHR_texture_basisu"},
           {"/extensionsRequired", {"VENDOR_anything"}, refused, "VENDOR_anything"}});
}

}  // namespace
