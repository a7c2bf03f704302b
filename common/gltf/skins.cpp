#include "common/gltf/skins.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/core/input_error.h"
#include "common/gltf/primitive.h"

namespace common::gltf {
namespace {

using Imath::M44d;

/// One set of influences, JOINTS_n and WEIGHTS_n: four of each for every vertex.
struct Influences {
    std::vector<float> joint;
    std::vector<float> weight;
};

std::vector<Influences> read_influences(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                        std::span<const std::uint32_t> vertices) {
    std::vector<Influences> sets;
    for (std::size_t set = 0;; ++set) {
        const std::string joints = fmt::format("JOINTS_{}", set), weights = fmt::format("WEIGHTS_{}", set);
        if (!primitive.attributes.contains(joints)) return sets;
        if (!primitive.attributes.contains(weights))
            throw InputError(fmt::format("{} has no {}", joints, weights));
        sets.push_back({read_attribute(accessors, primitive, joints.c_str(), 4, vertices),
                        read_attribute(accessors, primitive, weights.c_str(), 4, vertices)});
    }
}

const M44d& joint_transform(std::span<const M44d> joints_to_world, float joint) {
    if (!(joint >= 0 && joint < static_cast<float>(joints_to_world.size())))
        throw InputError(
            fmt::format("joint {} is beyond the {} joints of the skin", joint, joints_to_world.size()));
    return joints_to_world[static_cast<std::size_t>(joint)];
}

double sum_of_weights(std::span<const Influences> sets, std::size_t vertex) {
    double sum = 0;
    for (const Influences& set : sets) {
        for (std::size_t i = 4 * vertex; i < 4 * vertex + 4; ++i) sum += set.weight[i];
    }
    return sum;
}

M44d mean_transform(std::span<const Influences> sets, std::span<const M44d> joints_to_world,
                    std::size_t vertex, double sum) {
    M44d mean(0.0);
    for (const Influences& set : sets) {
        for (std::size_t i = 4 * vertex; i < 4 * vertex + 4; ++i) {
            // Joints of weight 0 may be invalid.
            if (set.weight[i] != 0)
                mean += joint_transform(joints_to_world, set.joint[i]) * (set.weight[i] / sum);
        }
    }
    return mean;
}

}  // namespace

Skins::Skins(const tinygltf::Model& model, std::span<const PlacedNode> nodes, AccessorReader& accessors)
    : model_(model), accessors_(accessors), placed_(model.nodes.size(), nullptr) {
    for (const PlacedNode& placed : nodes) placed_[static_cast<std::size_t>(placed.node)] = &placed;
}

std::vector<M44d> Skins::joints_to_world(int skin) const {
    const tinygltf::Skin& described = model_.skins[static_cast<std::size_t>(skin)];
    std::vector<float> inverse_bind;
    if (described.inverseBindMatrices >= 0) {
        if (accessors_.count(described.inverseBindMatrices, 16) < described.joints.size())
            throw InputError(fmt::format("skins/{} has more joints than inverse bind matrices", skin));
        std::vector<std::uint32_t> all(described.joints.size());
        std::iota(all.begin(), all.end(), 0u);
        inverse_bind = accessors_.read_vectors(described.inverseBindMatrices, 16, all);
    }
    std::vector<M44d> transforms;
    for (std::size_t i = 0; i < described.joints.size(); ++i) {
        const PlacedNode* joint = placed_[static_cast<std::size_t>(described.joints[i])];
        if (joint == nullptr) return {};
        M44d to_joint;
        if (!inverse_bind.empty()) {
            to_joint = matrix_of(std::span<const float>(inverse_bind).subspan(16 * i, 16));
            check_transform(to_joint);
        }
        transforms.push_back(to_joint * joint->to_world);
    }
    return transforms;
}

bool has_joints(const tinygltf::Primitive& primitive) {
    return primitive.attributes.contains("JOINTS_0");
}

std::vector<M44d> vertices_to_world(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                    std::span<const M44d> joints_to_world,
                                    std::span<const std::uint32_t> vertices, const std::string& name,
                                    Warnings& warnings) {
    const std::vector<Influences> sets = read_influences(accessors, primitive, vertices);
    std::vector<M44d> transforms(vertices.size());
    bool has_weights = true;
    for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex) {
        const double sum = sum_of_weights(sets, vertex);
        if (sum > 0) {
            transforms[vertex] = mean_transform(sets, joints_to_world, vertex, sum);
        } else {
            transforms[vertex] = joint_transform(joints_to_world, sets[0].joint[4 * vertex]);
            has_weights = false;
        }
    }
    if (!has_weights) warnings.add("vertices without weights moved with their first joint", name);
    return transforms;
}

}  // namespace common::gltf
