#include "common/gltf/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

/// Colour times intensity, in W/sr or W/m^2.
Rgb strength(const tinygltf::Light& light, const std::string& where) {
    Rgb color(1, 1, 1);
    for (std::size_t c = 0; c < light.color.size(); ++c)
        color[static_cast<int>(c)] = static_cast<float>(light.color[c]);
    if (std::min({color.x, color.y, color.z}) < 0 || light.intensity < 0)
        throw InputError(fmt::format("{} has a negative colour or intensity", where));
    color *= static_cast<float>(light.intensity);
    if (!is_finite(color)) throw InputError(fmt::format("{} has an intensity that is not finite", where));
    return color;
}

/// Rounds to float. The volatile works around GCC 12, which drops the conversion of two doubles to float and
/// back.
double nearest_float(double value) {
    volatile float rounded = static_cast<float>(value);
    return rounded;
}

SpotLight spot_light(const tinygltf::Light& light, const Vec3& position, const Vec3& axis,
                     const std::string& where, Warnings& warnings) {
    const double outer = std::clamp(light.spot.outerConeAngle, 0.0, std::numbers::pi / 2);
    const double inner = std::clamp(light.spot.innerConeAngle, 0.0, outer);
    if (outer != light.spot.outerConeAngle || inner != light.spot.innerConeAngle)
        warnings.add("cone angles clamped to 0 <= inner <= outer <= pi/2", where);
    SpotLight spot{position, axis, strength(light, where), std::cos(inner), std::cos(outer), one_line(where)};
    if (!spot.is_narrow()) {  // floats suffice, and keep existing maps and references the same to the bit
        spot.cos_inner_angle = nearest_float(spot.cos_inner_angle);
        spot.cos_outer_angle = nearest_float(spot.cos_outer_angle);
    }
    return spot;
}

void append_light(const tinygltf::Light& light, const PlacedNode& node, const std::string& where,
                  Scene& scene, Warnings& warnings) {
    const bool is_spot = light.type == "spot";
    if (!is_spot && light.type != "point" && light.type != "directional")
        throw InputError(fmt::format("{} is of the unknown type '{}'", where, light.type));
    const std::optional<Vec3> direction = node.direction({0, 0, -1});
    if (light.type != "point" && !direction) {
        warnings.add("lights left out whose node is scaled to nothing and has no direction", where);
        return;
    }
    if (light.range > 0) warnings.add("range of a light ignored", where);
    if (is_spot) {
        scene.spot_light.push_back(spot_light(light, node.origin(), *direction, where, warnings));
    } else if (light.type == "point") {
        scene.point_light.push_back({node.origin(), strength(light, where), one_line(where)});
    } else {
        scene.directional_light.push_back({*direction, strength(light, where), one_line(where)});
    }
}

}  // namespace

void append_lights(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                   Warnings& warnings) {
    for (const PlacedNode& placed : nodes) {
        const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(placed.node)];
        const auto extension = node.extensions.find("KHR_lights_punctual");
        if (!placed.is_visible || extension == node.extensions.end() || !extension->second.Has("light"))
            continue;
        const int index = extension->second.Get(std::string("light")).GetNumberAsInt();
        const tinygltf::Light& light = model.lights[static_cast<std::size_t>(index)];
        const std::string where =
            light.name.empty() ? fmt::format("lights/{}", index) : fmt::format("light '{}'", light.name);
        append_light(light, placed, where, scene, warnings);
    }
}

}  // namespace common::gltf
