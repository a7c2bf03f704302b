#include "common/gltf/mesh_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Imath::M44d;
using Imath::V3d;

constexpr const char* extension_name = "EXT_mesh_gpu_instancing";

/// Returns the numbers of one instance, or `missing` if there is no attribute.
template <std::size_t width>
std::array<double, width> numbers_or(AccessorReader& accessors, std::optional<int> attribute,
                                     std::size_t instance, std::array<double, width> missing) {
    if (!attribute) return missing;
    const auto element = static_cast<std::uint32_t>(instance);
    const std::vector<float> read =
        accessors.read_vectors(*attribute, static_cast<int>(width), std::span(&element, 1));
    std::array<double, width> numbers;
    std::copy(read.begin(), read.end(), numbers.begin());
    return numbers;
}

V3d vector_of(const std::array<double, 3>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

bool is_known(const std::string& attribute) {
    return attribute == "TRANSLATION" || attribute == "ROTATION" || attribute == "SCALE" ||
           attribute.starts_with('_');
}

}  // namespace

MeshInstances::MeshInstances(const tinygltf::Model& model, const PlacedNode& node, AccessorReader& accessors,
                             Warnings& warnings)
    : node_(node), accessors_(accessors) {
    const tinygltf::ExtensionMap& extensions = model.nodes[static_cast<std::size_t>(node.node)].extensions;
    const auto instancing = extensions.find(extension_name);
    if (instancing == extensions.end()) return;
    are_listed_ = true;
    count_ = 0;
    if (instancing->second.Has("attributes")) {
        const tinygltf::Value& attributes = instancing->second.Get(std::string("attributes"));
        for (const std::string& name : attributes.Keys()) {
            const int accessor = attributes.Get(name).GetNumberAsInt();
            read_attribute(name, accessor, model.accessors[static_cast<std::size_t>(accessor)].count);
            if (!is_known(name))
                warnings.add(fmt::format("instance attribute {} ignored", name), node_name(model, node.node));
        }
    }
    if (count_ == 0) throw InputError(fmt::format("{} has no attributes", extension_name));
}

void MeshInstances::read_attribute(const std::string& name, int accessor, std::size_t count) {
    if (name == "TRANSLATION") count = accessors_.count(*(translation_ = accessor), 3);
    if (name == "ROTATION") count = accessors_.count(*(rotation_ = accessor), 4);
    if (name == "SCALE") count = accessors_.count(*(scale_ = accessor), 3);
    if (count_ != 0 && count != count_)
        throw InputError(fmt::format("{}/attributes/{} has {} elements, others have {}", extension_name, name,
                                     count, count_));
    count_ = count;
}

M44d MeshInstances::to_world(std::size_t i) const {
    if (!are_listed_) return node_.to_world;
    const M44d local = transform_of(vector_of(numbers_or<3>(accessors_, scale_, i, {1, 1, 1})),
                                    numbers_or<4>(accessors_, rotation_, i, {0, 0, 0, 1}),
                                    vector_of(numbers_or<3>(accessors_, translation_, i, {0, 0, 0})));
    check_transform(local);
    const M44d to_world = local * node_.to_world;
    check_transform(to_world);
    return to_world;
}

}  // namespace common::gltf
