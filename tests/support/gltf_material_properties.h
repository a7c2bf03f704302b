// Properties of materials and of the data they read, where several readers together decide the treatment.
#pragma once

#include "tests/support/gltf_properties.h"

namespace gltf_text {

inline std::vector<Property> properties_of_surfaces() {
    using enum Treatment;
    const std::string material = "/materials/0/";
    const std::string pbr = "/materials/0/pbrMetallicRoughness/";
    const std::string extensions = "/materials/0/extensions/";
    const std::string transform = pbr + "baseColorTexture/extensions/KHR_texture_transform/";
    const std::string glossiness = extensions + "KHR_materials_pbrSpecularGlossiness/";
    const Json texture = {{"index", 0}};
    const Json half_clear = {0.5, 0.5, 0.5, 0.4};
    const std::vector<std::pair<std::string, Json>> mask = {{material + "alphaMode", "MASK"}};
    const std::vector<std::pair<std::string, Json>> smooth = {{pbr + "roughnessFactor", 0}};
    const std::vector<std::pair<std::string, Json>> glass = {
        {pbr + "roughnessFactor", 0}, {extensions + "KHR_materials_transmission/transmissionFactor", 1}};
    const std::vector<std::pair<std::string, Json>> body = {
        {pbr + "roughnessFactor", 0},
        {extensions + "KHR_materials_transmission/transmissionFactor", 1},
        {extensions + "KHR_materials_volume/thicknessFactor", 1}};
    return {
        // Alpha and colours of vertices.
        {material + "alphaMode", "MASK", drawn, "", {{pbr + "baseColorFactor", half_clear}}},
        {material + "alphaMode", "BLEND", drawn, "", {{pbr + "baseColorFactor", half_clear}}},
        {material + "alphaCutoff", 0.9, drawn, "", mask},
        {pbr + "baseColorFactor", half_clear, unseen},  // OPAQUE
        {"/meshes/0/primitives/0/attributes/COLOR_0", 1, drawn},
        {"/meshes/0/primitives/0/attributes/COLOR_0", 11, drawn},
        // Metal, roughness and occlusion.
        {pbr + "metallicFactor", 1, drawn, "", smooth},
        {pbr + "metallicFactor", 0.5, warned, "metal"},
        {pbr + "roughnessFactor", 0.5, warned, "metal", {{pbr + "metallicFactor", 1}}},
        {pbr + "metallicRoughnessTexture", texture, warned, "metal", {{pbr + "metallicFactor", 1}}},
        {material + "occlusionTexture", texture, warned, "occlusion"},
        // Textures.
        {transform + "offset", {0.5, 0}, drawn},
        {transform + "rotation", 1, drawn},
        {transform + "scale", {2, 1}, drawn},
        {transform + "texCoord", 1, drawn},
        {"/samplers/0/magFilter", 9728, drawn},
        {"/samplers/0/magFilter", 9729, unseen},
        {"/samplers/0/minFilter", 9728, warned, "minFilter"},
        // Glass.
        {extensions + "KHR_materials_transmission/transmissionFactor", 1, drawn, "", smooth},
        {extensions + "KHR_materials_transmission/transmissionFactor", 0.5, warned, "transmission", smooth},
        {extensions + "KHR_materials_transmission/transmissionTexture", texture, warned, "transmission",
         glass},
        {extensions + "KHR_materials_ior/ior", 1.2, drawn, "", glass},
        {extensions + "KHR_materials_volume/thicknessFactor", 1, drawn, "", glass},
        {extensions + "KHR_materials_volume/thicknessTexture", texture, drawn, "", body},
        {extensions + "KHR_materials_volume/attenuationDistance", 1, warned, "attenuation", body},
        {extensions + "KHR_materials_volume/attenuationColor",
         {1, 0, 0},
         warned,
         "attenuation",
         {{pbr + "roughnessFactor", 0},
          {extensions + "KHR_materials_transmission/transmissionFactor", 1},
          {extensions + "KHR_materials_volume/thicknessFactor", 1},
          {extensions + "KHR_materials_volume/attenuationDistance", 1}}},
        // Specular and glossiness: treated like the diffuse part, without the specular one.
        {glossiness + "diffuseFactor", {1, 0, 0, 1}, warned, "pecular"},
        {glossiness + "diffuseTexture", texture, warned, "pecular"},
        {glossiness + "specularFactor", {1, 0, 0}, warned, "pecular"},
        {glossiness + "glossinessFactor", 0.5, warned, "pecular"},
        {glossiness + "specularGlossinessTexture", texture, warned, "pecular"},
    };
}

}  // namespace gltf_text
