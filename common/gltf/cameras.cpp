#include "common/gltf/cameras.h"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

std::string camera_name(const tinygltf::Model& model, const tinygltf::Node& node) {
    const std::string& name = model.cameras[static_cast<std::size_t>(node.camera)].name;
    if (!name.empty()) return name;
    return node.name.empty() ? fmt::format("cameras/{}", node.camera) : node.name;
}

/// Returns nothing if the node's transform leaves no direction.
std::optional<Camera> perspective_camera(const tinygltf::PerspectiveCamera& lens, const PlacedNode& node,
                                         const std::string& name) {
    if (!(lens.yfov > 0 && lens.yfov < std::numbers::pi))
        throw InputError(fmt::format("camera '{}' has a field of view outside (0, pi)", name));
    const std::optional<Vec3> forward = node.direction({0, 0, -1});
    const std::optional<Vec3> upward = node.direction({0, 1, 0});
    if (!forward || !upward) return {};
    // Scaled and rotated parents can shear the axes.
    const Vec3 up = *upward - *forward * upward->dot(*forward);
    if (!(up.length() > 1e-6f)) return {};
    return Camera{name, node.origin(), *forward, up.normalized(), static_cast<float>(lens.yfov)};
}

}  // namespace

void append_cameras(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                    Warnings& warnings) {
    for (const PlacedNode& placed : nodes) {
        const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(placed.node)];
        if (node.camera < 0) continue;
        const tinygltf::Camera& camera = model.cameras[static_cast<std::size_t>(node.camera)];
        const std::string name = camera_name(model, node);
        if (camera.type != "perspective") {
            warnings.add("orthographic cameras left out", name);
        } else if (const auto perspective = perspective_camera(camera.perspective, placed, name)) {
            scene.camera.push_back(*perspective);
        } else {
            warnings.add("cameras left out whose node is scaled to nothing and has no direction", name);
        }
    }
}

}  // namespace common::gltf
