#include "common/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/core/input_error.h"
#include "common/gltf/accessor.h"

namespace common::gltf {
namespace {

/// The attribute's numbers; empty where the primitive does not have it.
std::vector<float> read_attribute(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                  const char* name, int components, std::size_t vertex_count) {
    const auto attribute = primitive.attributes.find(name);
    if (attribute == primitive.attributes.end()) return {};
    std::vector<float> values = read_vectors(model, attribute->second, components);
    const std::size_t count = values.size() / static_cast<std::size_t>(components);
    if (count != vertex_count)
        throw InputError(fmt::format("{} has {} elements, POSITION {}", name, count, vertex_count));
    return values;
}

std::vector<Vec2> pairs(std::span<const float> values) {
    std::vector<Vec2> result(values.size() / 2);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {values[2 * i], values[2 * i + 1]};
    return result;
}

/// The first three of every `components` numbers.
std::vector<Vec3> triples(std::span<const float> values, std::size_t components) {
    std::vector<Vec3> result(values.size() / components);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::span<const float> element = values.subspan(i * components, 3);
        result[i] = {element[0], element[1], element[2]};
    }
    return result;
}

std::vector<float> signs(std::span<const float> xyzw) {
    std::vector<float> result(xyzw.size() / 4);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = xyzw[4 * i + 3] < 0 ? -1.0f : 1.0f;
    return result;
}

/// The order in which the vertices follow each other.
std::vector<std::uint32_t> vertex_sequence(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                           std::uint32_t vertex_count) {
    if (primitive.indices >= 0) return read_indices(model, primitive.indices);
    std::vector<std::uint32_t> sequence(vertex_count);
    std::iota(sequence.begin(), sequence.end(), 0u);
    return sequence;
}

}  // namespace

bool is_made_of_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

Attributes read_attributes(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    Attributes attributes;
    attributes.position = triples(read_vectors(model, primitive.attributes.at("POSITION"), 3), 3);
    const std::size_t count = attributes.position.size();
    attributes.normal = triples(read_attribute(model, primitive, "NORMAL", 3, count), 3);
    const std::vector<float> tangent = read_attribute(model, primitive, "TANGENT", 4, count);
    attributes.tangent = triples(tangent, 4);
    attributes.tangent_sign = signs(tangent);
    attributes.texcoord[0] = pairs(read_attribute(model, primitive, "TEXCOORD_0", 2, count));
    attributes.texcoord[1] = pairs(read_attribute(model, primitive, "TEXCOORD_1", 2, count));
    return attributes;
}

std::vector<TriangleVertices> read_triangles(const tinygltf::Model& model,
                                             const tinygltf::Primitive& primitive,
                                             std::uint32_t vertex_count) {
    const std::vector<std::uint32_t> sequence = vertex_sequence(model, primitive, vertex_count);
    const std::uint32_t largest = *std::max_element(sequence.begin(), sequence.end());
    if (largest >= vertex_count)
        throw InputError(fmt::format("index {} is beyond the {} vertices", largest, vertex_count));

    // glTF 2.0, section 3.7.2.1.
    std::vector<TriangleVertices> triangles;
    switch (primitive.mode) {
        case TINYGLTF_MODE_TRIANGLES:
            for (std::size_t i = 0; i + 2 < sequence.size(); i += 3)
                triangles.push_back({sequence[i], sequence[i + 1], sequence[i + 2]});
            break;
        case TINYGLTF_MODE_TRIANGLE_STRIP:
            for (std::size_t i = 0; i + 2 < sequence.size(); ++i)
                triangles.push_back({sequence[i], sequence[i + 1 + i % 2], sequence[i + 2 - i % 2]});
            break;
        default:
            for (std::size_t i = 0; i + 2 < sequence.size(); ++i)
                triangles.push_back({sequence[i + 1], sequence[i + 2], sequence[0]});
    }
    return triangles;
}

}  // namespace common::gltf
