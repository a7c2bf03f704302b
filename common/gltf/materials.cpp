#include "common/gltf/materials.h"

#include <Imath/ImathFun.h>
#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/gltf/extension_values.h"
#include "common/gltf/not_drawn.h"
#include "common/gltf/texture_use.h"
#include "common/gltf/textures.h"

namespace common::gltf {
namespace {

Rgb rgb_of(const std::vector<double>& values) {
    return {static_cast<float>(values[0]), static_cast<float>(values[1]), static_cast<float>(values[2])};
}

/// Reads one material.
class MaterialReader {
  public:
    MaterialReader(const tinygltf::Material& source, std::string place, TextureLoader& textures,
                   Warnings& warnings)
        : source_(source), place_(std::move(place)), textures_(textures), warnings_(warnings) {}

    [[nodiscard]] Material read() {
        Material material;
        material.name = source_.name;
        material.double_sided = source_.doubleSided;
        read_kind(material);
        read_alpha_mode(material);
        read_base_color(material);
        read_normal_texture(material);
        read_emission(material);
        if (!is_unlit()) warn_about_what_is_not_drawn(source_, material.kind, place_, warnings_);
        return material;
    }

  private:
    void warn(const char* what) { warnings_.add(what, place_); }

    [[nodiscard]] bool has_extension(const char* name) const { return source_.extensions.contains(name); }
    [[nodiscard]] const tinygltf::Value& extension(const char* name) const {
        return extension_object(source_.extensions, name);
    }
    [[nodiscard]] bool is_unlit() const { return has_extension("KHR_materials_unlit"); }
    /// Returns whether pbrMetallicRoughness is only a fallback for readers without that extension.
    [[nodiscard]] bool is_specular_glossy() const {
        return has_extension("KHR_materials_pbrSpecularGlossiness");
    }

    [[nodiscard]] bool is_mirror() const {
        const auto& pbr = source_.pbrMetallicRoughness;
        return pbr.metallicFactor >= 0.99 && pbr.roughnessFactor <= 0.01 &&
               pbr.metallicRoughnessTexture.index < 0;
    }

    void read_kind(Material& material) {
        if (is_unlit()) {
            warn("KHR_materials_unlit treated as diffuse");
        } else if (is_specular_glossy()) {
            warn_about_specular_part();
        } else if (is_mirror()) {
            material.kind = SurfaceKind::mirror;
        } else {
            if (source_.pbrMetallicRoughness.metallicFactor > 0) warn(metal_warning);
            read_transmission(material);
        }
    }

    void warn_about_specular_part() {
        const auto specular =
            numbers_or(extension("KHR_materials_pbrSpecularGlossiness"), "specularFactor", {1, 1, 1});
        if (specular != std::vector<double>{0, 0, 0})
            warn("KHR_materials_pbrSpecularGlossiness: specular part not drawn");
    }

    void read_transmission(Material& material) {
        const tinygltf::Value& transmission = extension("KHR_materials_transmission");
        const auto& pbr = source_.pbrMetallicRoughness;
        // Metal transmits nothing. With a texture the metallic part is unknown, as the texture is not read.
        const double metal = pbr.metallicRoughnessTexture.index < 0 ? pbr.metallicFactor : 0;
        const double transmitted = number_or(transmission, "transmissionFactor", 0) * (1 - metal);
        if (transmitted <= 0) return;
        if (transmitted < 0.5) {
            warn("KHR_materials_transmission: transmission of less than one half treated as none");
            return;
        }
        if (transmitted < 1 || transmission.Has("transmissionTexture") || pbr.roughnessFactor > 0.01)
            warn("KHR_materials_transmission: partial or rough transmission treated as clear, smooth glass");
        read_glass(material);
    }

    void read_glass(Material& material) {
        const bool has_inside = number_or(extension("KHR_materials_volume"), "thicknessFactor", 0) > 0;
        material.kind = has_inside ? SurfaceKind::dielectric : SurfaceKind::thin_sheet;
        const auto ior = static_cast<float>(number_or(extension("KHR_materials_ior"), "ior", 1.5));
        if (ior >= 1) {
            material.index_of_refraction = ior;
        } else {
            warn("KHR_materials_ior: index of refraction below 1 replaced by 1.5");
        }
    }

    void read_alpha_mode(Material& material) {
        if (source_.alphaMode == "MASK") {
            material.alpha_mode = AlphaMode::mask;
        } else if (source_.alphaMode == "BLEND") {
            material.alpha_mode = AlphaMode::blend;
        } else if (source_.alphaMode != "OPAQUE") {
            warn("alphaMode that glTF does not know treated as OPAQUE");
        }
        material.alpha_cutoff = static_cast<float>(source_.alphaCutoff);
    }

    void read_base_color(Material& material) {
        const tinygltf::Value& glossy = extension("KHR_materials_pbrSpecularGlossiness");
        const auto& pbr = source_.pbrMetallicRoughness;
        const std::vector<double> rgba =
            is_specular_glossy() ? numbers_or(glossy, "diffuseFactor", {1, 1, 1, 1}) : pbr.baseColorFactor;
        const Rgb given = rgb_of(rgba);
        for (int c = 0; c < 3; ++c) material.base_color[c] = Imath::clamp(given[c], 0.0f, 1.0f);
        if (material.base_color != given) warn("base colour clamped to [0, 1]");
        material.alpha = Imath::clamp(static_cast<float>(rgba[3]), 0.0f, 1.0f);
        material.base_color_texture = read_texture(
            is_specular_glossy() ? texture_info(glossy, "diffuseTexture") : pbr.baseColorTexture,
            ColorSpace::srgb, material.alpha_mode == AlphaMode::opaque ? Alpha::left_out : Alpha::kept);
    }

    void read_normal_texture(Material& material) {
        material.normal_texture = read_texture(source_.normalTexture, ColorSpace::linear);
        material.normal_scale = static_cast<float>(source_.normalTexture.scale);
    }

    void read_emission(Material& material) {
        const double strength =
            number_or(extension("KHR_materials_emissive_strength"), "emissiveStrength", 1);
        // Factors above 1 violate the specification, but their meaning is clear and they are common.
        Rgb radiance = rgb_of(source_.emissiveFactor) * static_cast<float>(strength);
        if (!is_finite(radiance))
            throw InputError(fmt::format("{} has an emission that is not finite", place_));
        for (int c = 0; c < 3; ++c) {
            if (radiance[c] < 0) warn("negative emission treated as none");
            radiance[c] = std::max(radiance[c], 0.0f);
        }
        if (!(max_component(radiance) > 0)) return;
        if (is_unlit()) {
            warn("emission of an unlit material left out");
            return;
        }
        material.emitted_radiance = radiance;
        material.emissive_texture = read_texture(source_.emissiveTexture, ColorSpace::srgb);
    }

    template <class TextureInfo>
    [[nodiscard]] TextureUse read_texture(const TextureInfo& info, ColorSpace color_space,
                                          Alpha alpha = Alpha::left_out) {
        if (info.index < 0) return {};
        const int set = texcoord_set(info.texCoord, info.extensions);
        if (set > 1) {
            warn("texture left out, which uses TEXCOORD_2 or above");
            return {};
        }
        return {textures_.load(info.index, color_space, alpha), set, texcoord_transform(info.extensions)};
    }

    const tinygltf::Material& source_;
    std::string place_;
    TextureLoader& textures_;
    Warnings& warnings_;
};

}  // namespace

void append_materials(const tinygltf::Model& model, Scene& scene, Warnings& warnings) {
    TextureLoader textures(model);
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        const tinygltf::Material& source = model.materials[i];
        const std::string place =
            source.name.empty() ? fmt::format("materials/{}", i) : fmt::format("material '{}'", source.name);
        scene.material.push_back(MaterialReader(source, place, textures, warnings).read());
    }
    Material default_material;
    default_material.name = "default";
    scene.material.push_back(default_material);
    scene.texture = textures.take();
}

std::uint32_t material_index(const Scene& scene, int material) {
    return static_cast<std::uint32_t>(material < 0 ? scene.material.size() - 1
                                                   : static_cast<std::size_t>(material));
}

}  // namespace common::gltf
