#include "common/gltf/vertex_colors.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/gltf/primitive.h"

namespace common::gltf {
namespace {

constexpr const char* first_set = "COLOR_0";

void warn_about_other_sets(const tinygltf::Primitive& primitive, const std::string& name,
                           Warnings& warnings) {
    for (const auto& [attribute, accessor] : primitive.attributes)
        if (attribute.starts_with("COLOR_") && attribute != first_set)
            warnings.add(fmt::format("{} left out, only {} is a colour of the surface", attribute, first_set),
                         name);
}

/// Returns the value that stands for 1: the largest integer if the file does not mark integers as normalized,
/// else 1.
float full_scale(const tinygltf::Accessor& accessor) {
    if (accessor.normalized) return 1;
    switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 255;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 65535;
        default:
            return 1;
    }
}

/// Brings the file's colour values to [0, 1], with `full` as 1.
void mend(std::vector<float>& values, float full, const std::string& name, Warnings& warnings) {
    bool is_broken = false, is_beyond = false;
    for (float& value : values) {
        value /= full;
        is_broken |= !std::isfinite(value);
        if (!std::isfinite(value)) value = 1;
        is_beyond |= value < 0 || value > 1;
        value = std::clamp(value, 0.0f, 1.0f);
    }
    if (full != 1) warnings.add("vertex colours that are not normalized read as if they were", name);
    if (is_broken) warnings.add("vertex colours that are not finite replaced by white", name);
    if (is_beyond) warnings.add("vertex colours clamped to [0, 1]", name);
}

bool change_nothing(const VertexColors& colors, const Material& material) {
    const auto is_white = [](const Rgb& color) { return color == Rgb(1, 1, 1); };
    const auto is_whole = [](float alpha) { return alpha == 1; };
    return std::ranges::all_of(colors.color, is_white) &&
           (material.alpha_mode == AlphaMode::opaque || std::ranges::all_of(colors.alpha, is_whole));
}

}  // namespace

VertexColors read_vertex_colors(AccessorReader& accessors, const tinygltf::Model& model,
                                const tinygltf::Primitive& primitive, const Material& material,
                                std::span<const std::uint32_t> vertices, const std::string& name,
                                Warnings& warnings) {
    warn_about_other_sets(primitive, name, warnings);
    const auto attribute = primitive.attributes.find(first_set);
    if (attribute == primitive.attributes.end()) return {};
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(attribute->second)];
    const int width = accessor.type == TINYGLTF_TYPE_VEC4 ? 4 : 3;
    const auto components = static_cast<std::size_t>(width);
    std::vector<float> values = read_attribute(accessors, primitive, first_set, width, vertices);
    mend(values, full_scale(accessor), name, warnings);

    VertexColors colors;
    for (std::size_t i = 0; i < values.size(); i += components) {
        colors.color.emplace_back(values[i], values[i + 1], values[i + 2]);
        colors.alpha.push_back(components == 4 ? values[i + 3] : 1.0f);
    }
    return change_nothing(colors, material) ? VertexColors{} : colors;
}

}  // namespace common::gltf
