#include "common/gltf/not_drawn.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string_view>

#include "common/gltf/extension_values.h"

namespace common::gltf {
namespace {

/// A property that has an effect unless it is `neutral`: a number, a list of numbers, or a texture.
struct Property {
    const char* extension;
    const char* key;
    double neutral;
};

constexpr std::array<Property, 10> on_any_surface = {{
    {"KHR_materials_anisotropy", "anisotropyStrength", 0},
    {"KHR_materials_clearcoat", "clearcoatFactor", 0},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0},
    {"KHR_materials_dispersion", "dispersion", 0},
    {"KHR_materials_iridescence", "iridescenceFactor", 0},
    {"KHR_materials_sheen", "sheenColorFactor", 0},
    {"KHR_materials_specular", "specularFactor", 1},
    {"KHR_materials_specular", "specularColorFactor", 1},
    {"KHR_materials_specular", "specularTexture", 0},
    {"KHR_materials_specular", "specularColorTexture", 0},
}};

bool says_something(const tinygltf::Value& value, double neutral) {
    if (value.IsNumber()) return value.GetNumberAsDouble() != neutral;
    for (std::size_t i = 0; i < value.ArrayLen(); ++i) {
        if (value.Get(static_cast<int>(i)).GetNumberAsDouble() != neutral) return true;
    }
    return value.IsObject();
}

bool says_something(const tinygltf::ExtensionMap& extensions, const Property& property) {
    const tinygltf::Value& object = extension_object(extensions, property.extension);
    return object.Has(property.key) &&
           says_something(object.Get(std::string(property.key)), property.neutral);
}

bool absorbs(const tinygltf::ExtensionMap& extensions) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const tinygltf::Value& volume = extension_object(extensions, "KHR_materials_volume");
    return number_or(volume, "attenuationDistance", never) < never &&
           says_something(extensions, {"KHR_materials_volume", "attenuationColor", 1});
}

}  // namespace

void warn_about_what_is_not_drawn(const tinygltf::Material& source, SurfaceKind kind,
                                  const std::string& place, Warnings& warnings) {
    const auto& extensions = source.extensions;
    // Several properties of one extension make one warning.
    std::string_view last;
    for (const Property& property : on_any_surface) {
        if (property.extension == last || !says_something(extensions, property)) continue;
        last = property.extension;
        warnings.add(fmt::format("{} not drawn", property.extension), place);
    }
    const bool is_glass = kind == SurfaceKind::dielectric || kind == SurfaceKind::thin_sheet;
    if (kind == SurfaceKind::diffuse && says_something(extensions, {"KHR_materials_ior", "ior", 1.5}))
        warnings.add("KHR_materials_ior drawn on glass only", place);
    if (is_glass && absorbs(extensions))
        warnings.add("KHR_materials_volume: absorption (attenuationColor) not drawn", place);
    if (is_glass && says_something(extensions, {"KHR_materials_volume", "thicknessTexture", 0}))
        warnings.add("KHR_materials_volume: thicknessTexture not read", place);
    if (source.occlusionTexture.index >= 0 && source.occlusionTexture.strength != 0)
        warnings.add("occlusionTexture not drawn: light is traced", place);
}

}  // namespace common::gltf
