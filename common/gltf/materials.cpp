#include "common/gltf/materials.h"

#include <Imath/ImathFun.h>
#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/gltf/textures.h"

namespace common::gltf {
namespace {

using Extensions = tinygltf::ExtensionMap;

double number_or(const tinygltf::Value& object, const char* key, double missing) {
    return object.Has(key) ? object.Get(std::string(key)).GetNumberAsDouble() : missing;
}

/// A number of an extension's object; `missing` too where the extension is not used.
double number_or(const Extensions& extensions, const char* extension, const char* key, double missing) {
    const auto found = extensions.find(extension);
    return found == extensions.end() ? missing : number_or(found->second, key, missing);
}

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
        read_base_color(material);
        read_normal_texture(material);
        read_emission(material);
        if (source_.alphaMode != "OPAQUE") warn("alpha (MASK or BLEND) treated as opaque");
        return material;
    }

  private:
    void warn(const char* what) { warnings_.add(what, place_); }

    [[nodiscard]] bool has_extension(const char* name) const { return source_.extensions.contains(name); }

    [[nodiscard]] bool is_mirror() const {
        const auto& pbr = source_.pbrMetallicRoughness;
        return pbr.metallicFactor >= 0.99 && pbr.roughnessFactor <= 0.01 &&
               pbr.metallicRoughnessTexture.index < 0;
    }

    void read_kind(Material& material) {
        if (has_extension("KHR_materials_unlit")) {
            warn("unlit treated as diffuse");
        } else if (is_mirror()) {
            material.kind = SurfaceKind::mirror;
        } else if (number_or(source_.extensions, "KHR_materials_transmission", "transmissionFactor", 0) >=
                   0.5) {
            material.kind = SurfaceKind::dielectric;
            read_dielectric(material);
        }
    }

    void read_dielectric(Material& material) {
        const tinygltf::Value& transmission = source_.extensions.at("KHR_materials_transmission");
        const auto& pbr = source_.pbrMetallicRoughness;
        if (number_or(transmission, "transmissionFactor", 0) < 1 || transmission.Has("transmissionTexture") ||
            pbr.roughnessFactor > 0.01 || pbr.metallicRoughnessTexture.index >= 0)
            warn("partial or rough transmission treated as clear, smooth glass");
        const auto ior = static_cast<float>(number_or(source_.extensions, "KHR_materials_ior", "ior", 1.5));
        if (ior >= 1) {
            material.index_of_refraction = ior;
        } else {
            warn("index of refraction below 1 replaced by 1.5");
        }
    }

    void read_base_color(Material& material) {
        const auto& pbr = source_.pbrMetallicRoughness;
        const Rgb given = rgb_of(pbr.baseColorFactor);
        for (int c = 0; c < 3; ++c) material.base_color[c] = Imath::clamp(given[c], 0.0f, 1.0f);
        if (material.base_color != given) warn("base colour clamped to [0, 1]");
        material.base_color_texture = read_texture(pbr.baseColorTexture, ColorSpace::srgb);
    }

    void read_normal_texture(Material& material) {
        material.normal_texture = read_texture(source_.normalTexture, ColorSpace::linear);
        material.normal_scale = static_cast<float>(source_.normalTexture.scale);
    }

    void read_emission(Material& material) {
        const double strength =
            number_or(source_.extensions, "KHR_materials_emissive_strength", "emissiveStrength", 1);
        // Factors above 1 break the specification, but say clearly what they mean and are common.
        Rgb radiance = rgb_of(source_.emissiveFactor) * static_cast<float>(strength);
        if (!is_finite(radiance))
            throw InputError(fmt::format("{} has an emission that is not finite", place_));
        for (int c = 0; c < 3; ++c) {
            if (radiance[c] < 0) warn("negative emission treated as none");
            radiance[c] = std::max(radiance[c], 0.0f);
        }
        if (!(max_component(radiance) > 0)) return;
        if (has_extension("KHR_materials_unlit")) {
            warn("emission of an unlit material left out");
            return;
        }
        material.emitted_radiance = radiance;
        material.emissive_texture = read_texture(source_.emissiveTexture, ColorSpace::srgb);
    }

    template <class TextureInfo>
    [[nodiscard]] TextureUse read_texture(const TextureInfo& info, ColorSpace color_space) {
        if (info.index < 0) return {};
        if (info.texCoord > 1) {
            warn("texture left out, which uses TEXCOORD_2 or above");
            return {};
        }
        if (is_transformed(info.extensions)) warn("KHR_texture_transform ignored");
        return {textures_.load(info.index, color_space), info.texCoord};
    }

    [[nodiscard]] static bool is_transformed(const Extensions& extensions) {
        // Exporters write the extension with all its defaults too.
        const auto transform = extensions.find("KHR_texture_transform");
        if (transform == extensions.end()) return false;
        const auto pair_is = [&](const char* key, double value) {
            if (!transform->second.Has(key)) return true;
            const tinygltf::Value& pair = transform->second.Get(std::string(key));
            return pair.ArrayLen() == 2 && pair.Get(0).GetNumberAsDouble() == value &&
                   pair.Get(1).GetNumberAsDouble() == value;
        };
        return !pair_is("offset", 0) || !pair_is("scale", 1) ||
               number_or(transform->second, "rotation", 0) != 0 || transform->second.Has("texCoord");
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
