#include "common/gltf/placed_nodes.h"

#include <Imath/ImathQuat.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Imath::M44d;
using Imath::V3d;

V3d vector_or(const std::vector<double>& values, const V3d& missing) {
    return values.size() == 3 ? V3d(values[0], values[1], values[2]) : missing;
}

M44d local_transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return matrix_of(std::span<const double>(node.matrix));
    std::array<double, 4> rotation{0, 0, 0, 1};
    if (node.rotation.size() == 4) std::copy(node.rotation.begin(), node.rotation.end(), rotation.begin());
    return transform_of(vector_or(node.scale, V3d(1)), rotation, vector_or(node.translation, V3d(0)));
}

bool hides(const tinygltf::Node& node) {
    const auto visibility = node.extensions.find("KHR_node_visibility");
    return visibility != node.extensions.end() && visibility->second.Has("visible") &&
           !visibility->second.Get(std::string("visible")).Get<bool>();
}

/// The nodes that no other node has as a child.
std::vector<int> root_nodes(const tinygltf::Model& model) {
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

std::vector<int> scene_roots(const tinygltf::Model& model) {
    if (model.scenes.empty()) return root_nodes(model);
    return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
}

M44d transform_under(const M44d& parent, const tinygltf::Model& model, int node) {
    try {
        const M44d local = local_transform(model.nodes[static_cast<std::size_t>(node)]);
        check_transform(local);
        const M44d to_world = local * parent;
        check_transform(to_world);
        return to_world;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} {}", node_name(model, node), error.what()));
    }
}

}  // namespace

std::optional<Vec3> PlacedNode::direction(const Imath::V3d& local) const {
    V3d world;
    to_world.multDirMatrix(local, world);
    if (!(world.length() > 0)) return {};
    return Vec3(world.normalized());
}

M44d transform_of(const V3d& scale, const std::array<double, 4>& rotation, const V3d& translation) {
    const V3d axis(rotation[0], rotation[1], rotation[2]);
    const double length = std::sqrt(axis.length2() + rotation[3] * rotation[3]);
    if (!(length > 0) || !std::isfinite(length))
        throw InputError("has a rotation that is not a unit quaternion");
    M44d scaling, moving;
    scaling.setScale(scale);
    moving.setTranslation(translation);
    return scaling * Imath::Quatd(rotation[3] / length, axis / length).toMatrix44() * moving;
}

void check_transform(const M44d& matrix) {
    const double* element = matrix.getValue();
    for (int i = 0; i < 16; ++i) {
        // Positions end up as floats.
        if (!(std::abs(element[i]) <= std::numeric_limits<float>::max()))
            throw InputError("has a transform that is not finite");
    }
    constexpr double rounding = 1e-6;
    if (std::abs(matrix[0][3]) > rounding || std::abs(matrix[1][3]) > rounding ||
        std::abs(matrix[2][3]) > rounding || std::abs(matrix[3][3] - 1) > rounding)
        throw InputError("has a matrix whose last row is not 0 0 0 1");
}

std::vector<PlacedNode> place_nodes(const tinygltf::Model& model) {
    std::vector<PlacedNode> placed;
    std::vector<bool> is_reached(model.nodes.size(), false);
    const auto place = [&](int node, const M44d& parent, bool is_visible) {
        if (is_reached[static_cast<std::size_t>(node)])
            throw InputError(fmt::format("{} is in a loop or has two parents", node_name(model, node)));
        is_reached[static_cast<std::size_t>(node)] = true;
        placed.push_back({node, transform_under(parent, model, node),
                          is_visible && !hides(model.nodes[static_cast<std::size_t>(node)])});
    };
    for (const int root : scene_roots(model)) place(root, M44d(), true);
    // Breadth-first without recursion, as a file may nest deeply. The list grows during the walk.
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PlacedNode parent = placed[i];
        for (const int child : model.nodes[static_cast<std::size_t>(parent.node)].children)
            place(child, parent.to_world, parent.is_visible);
    }
    return placed;
}

std::string node_name(const tinygltf::Model& model, int node) {
    const std::string& name = model.nodes[static_cast<std::size_t>(node)].name;
    return name.empty() ? fmt::format("nodes/{}", node) : fmt::format("node '{}'", name);
}

}  // namespace common::gltf
