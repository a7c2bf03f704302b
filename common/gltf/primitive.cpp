#include "common/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

constexpr std::uint32_t not_numbered = std::numeric_limits<std::uint32_t>::max();

std::vector<Vec2> pairs(std::span<const float> values) {
    std::vector<Vec2> result(values.size() / 2);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {values[2 * i], values[2 * i + 1]};
    return result;
}

/// Returns the first three of every `components` numbers.
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

/// Returns the sequence of vertices: the primitive's indices, else 0, 1, ...
std::vector<std::uint32_t> vertex_sequence(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                           std::uint32_t vertex_count) {
    if (primitive.indices >= 0) return accessors.read_indices(primitive.indices);
    std::vector<std::uint32_t> sequence(vertex_count);
    std::iota(sequence.begin(), sequence.end(), 0u);
    return sequence;
}

/// Splits a sequence of vertices into triangles: glTF 2.0, section 3.7.2.1.
std::vector<TriangleVertices> triangles_of(std::span<const std::uint32_t> sequence, int mode) {
    std::vector<TriangleVertices> triangles;
    switch (mode) {
        case TINYGLTF_MODE_TRIANGLES:
            triangles.reserve(sequence.size() / 3);
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

}  // namespace

bool is_made_of_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

PrimitiveTriangles TriangleReader::read(const tinygltf::Primitive& primitive) {
    const auto vertex_count =
        static_cast<std::uint32_t>(accessors_.count(primitive.attributes.at("POSITION"), 3));
    const std::vector<std::uint32_t> sequence = vertex_sequence(accessors_, primitive, vertex_count);
    const std::uint32_t largest = *std::max_element(sequence.begin(), sequence.end());
    if (largest >= vertex_count)
        throw InputError(fmt::format("index {} is beyond the {} vertices", largest, vertex_count));

    PrimitiveTriangles triangles{triangles_of(sequence, primitive.mode), {}};
    triangles.vertex = number_vertices(triangles.triangle, vertex_count);
    return triangles;
}

std::vector<std::uint32_t> TriangleReader::number_vertices(std::span<TriangleVertices> triangles,
                                                           std::uint32_t vertex_count) {
    if (number_of_.size() < vertex_count) number_of_.resize(vertex_count, not_numbered);
    std::vector<std::uint32_t> vertices;
    for (TriangleVertices& corners : triangles) {
        for (std::uint32_t& corner : corners) {
            std::uint32_t& number = number_of_[corner];
            if (number == not_numbered) {
                number = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(corner);
            }
            corner = number;
        }
    }
    for (const std::uint32_t vertex : vertices) number_of_[vertex] = not_numbered;
    return vertices;
}

std::vector<float> read_attribute(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                  const char* name, int components, std::span<const std::uint32_t> vertices) {
    const auto attribute = primitive.attributes.find(name);
    if (attribute == primitive.attributes.end()) return {};
    const std::size_t count = accessors.count(attribute->second, components);
    const std::size_t vertex_count = accessors.count(primitive.attributes.at("POSITION"), 3);
    if (count != vertex_count)
        throw InputError(fmt::format("{} has {} elements, POSITION {}", name, count, vertex_count));
    return accessors.read_vectors(attribute->second, components, vertices);
}

Attributes read_attributes(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                           std::span<const std::uint32_t> vertices) {
    const auto read = [&](const char* name, int components) {
        return read_attribute(accessors, primitive, name, components, vertices);
    };
    Attributes attributes;
    attributes.position = triples(read("POSITION", 3), 3);
    attributes.normal = triples(read("NORMAL", 3), 3);
    const std::vector<float> tangent = read("TANGENT", 4);
    attributes.tangent = triples(tangent, 4);
    attributes.tangent_sign = signs(tangent);
    attributes.texcoord[0] = pairs(read("TEXCOORD_0", 2));
    attributes.texcoord[1] = pairs(read("TEXCOORD_1", 2));
    return attributes;
}

}  // namespace common::gltf
