#include "common/gltf/morph_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Target = std::map<std::string, int>;

/// Adds one target times its weight to one primitive's attributes.
class TargetAdder {
  public:
    TargetAdder(AccessorReader& accessors, std::span<const std::uint32_t> vertices, std::size_t vertex_count)
        : accessors_(accessors), vertices_(vertices), vertex_count_(vertex_count) {}

    void add(const Target& target, float weight, Attributes& attributes) {
        add("POSITION", target, weight, attributes.position);
        add("NORMAL", target, weight, attributes.normal);
        add("TANGENT", target, weight, attributes.tangent);
        add("TEXCOORD_0", target, weight, attributes.texcoord[0]);
        add("TEXCOORD_1", target, weight, attributes.texcoord[1]);
    }

  private:
    template <class Vector>
    void add(const char* name, const Target& target, float weight, std::vector<Vector>& values) {
        const auto attribute = target.find(name);
        if (attribute == target.end() || values.empty()) return;
        constexpr int components = sizeof(Vector) / sizeof(float);
        const std::size_t count = accessors_.count(attribute->second, components);
        if (count != vertex_count_)
            throw InputError(
                fmt::format("{} of a morph target has {} elements, POSITION {}", name, count, vertex_count_));
        const std::vector<float> change = accessors_.read_vectors(attribute->second, components, vertices_);
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (int c = 0; c < components; ++c)
                values[i][c] += weight * change[i * components + static_cast<std::size_t>(c)];
        }
    }

    AccessorReader& accessors_;
    std::span<const std::uint32_t> vertices_;
    std::size_t vertex_count_;
};

void warn_about_colors(const Target& target, const std::string& name, Warnings& warnings) {
    for (const auto& [attribute, accessor] : target) {
        if (attribute.starts_with("COLOR_"))
            warnings.add(fmt::format("{} of a morph target ignored", attribute), name);
    }
}

}  // namespace

std::span<const double> rest_weights(const tinygltf::Mesh& mesh, const tinygltf::Node& node) {
    return node.weights.empty() ? mesh.weights : node.weights;
}

void morph(AccessorReader& accessors, const tinygltf::Primitive& primitive, std::span<const double> weights,
           std::span<const std::uint32_t> vertices, Attributes& attributes, const std::string& name,
           Warnings& warnings) {
    if (weights.size() > primitive.targets.size())
        warnings.add("weights without a morph target ignored", name);
    TargetAdder adder(accessors, vertices, accessors.count(primitive.attributes.at("POSITION"), 3));
    for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i) {
        if (weights[i] == 0) continue;
        adder.add(primitive.targets[i], static_cast<float>(weights[i]), attributes);
        warn_about_colors(primitive.targets[i], name, warnings);
    }
}

}  // namespace common::gltf
