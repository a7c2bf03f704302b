#include "common/gltf/world_space.h"

#include <algorithm>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Imath::V3d;

/// Largest coordinate, in metres, whose squared lengths do not overflow float.
constexpr float farthest = 1e18f;

template <class Vector>
bool repair(std::vector<Vector>& values) {
    bool is_broken = false;
    for (Vector& value : values) {
        if (is_finite(value)) continue;
        value = Vector(0);
        is_broken = true;
    }
    return is_broken;
}

/// The linear part of a transform: the images of the axes.
struct Linear {
    V3d x, y, z;

    explicit Linear(const Imath::M44d& matrix)
        : x(matrix[0][0], matrix[0][1], matrix[0][2]),
          y(matrix[1][0], matrix[1][1], matrix[1][2]),
          z(matrix[2][0], matrix[2][1], matrix[2][2]) {}

    [[nodiscard]] bool is_mirroring() const { return x.cross(y).dot(z) < 0; }
    [[nodiscard]] V3d direction(const V3d& v) const { return x * v.x + y * v.y + z * v.z; }
    /// Transforms a normal by the cofactor matrix: the inverse transpose times the determinant, which also
    /// exists for singular transforms.
    [[nodiscard]] V3d normal(const V3d& n) const {
        const V3d scaled = y.cross(z) * n.x + z.cross(x) * n.y + x.cross(y) * n.z;
        return is_mirroring() ? -scaled : scaled;
    }
};

Vec3 world_position(const Vec3& local, const Imath::M44d& to_world) {
    const Vec3 world(V3d(local) * to_world);
    const bool is_near =
        std::abs(world.x) <= farthest && std::abs(world.y) <= farthest && std::abs(world.z) <= farthest;
    if (!is_near) throw InputError("has a position that is not finite or absurdly far away");
    return world;
}

void move_vertex(Attributes& attributes, std::size_t i, const Imath::M44d& to_world, const Linear& linear) {
    attributes.position[i] = world_position(attributes.position[i], to_world);
    if (!attributes.normal.empty())
        attributes.normal[i] = Vec3(linear.normal(V3d(attributes.normal[i])).normalized());
    if (attributes.tangent.empty()) return;
    attributes.tangent[i] = Vec3(linear.direction(V3d(attributes.tangent[i])).normalized());
    // Under mirroring, cross(normal, tangent) is opposite to the mirrored bitangent.
    if (linear.is_mirroring()) attributes.tangent_sign[i] = -attributes.tangent_sign[i];
}

}  // namespace

void repair(Attributes& attributes, const std::string& name, Warnings& warnings) {
    if (repair(attributes.normal))
        warnings.add("normals that are not finite replaced by the triangle's own", name);
    if (repair(attributes.tangent)) warnings.add("tangents that are not finite left out", name);
    for (std::vector<Vec2>& texcoord : attributes.texcoord) {
        if (repair(texcoord)) warnings.add("texture coordinates that are not finite replaced by zero", name);
    }
}

void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    const Imath::M44d& to_world) {
    const Linear linear(to_world);
    for (std::size_t i = 0; i < attributes.position.size(); ++i) move_vertex(attributes, i, to_world, linear);
    if (!linear.is_mirroring()) return;
    for (TriangleVertices& corners : triangles) std::swap(corners[1], corners[2]);
}

void to_world_space(std::span<CornerTangents> tangents, const Imath::M44d& to_world) {
    const Linear linear(to_world);
    for (CornerTangents& corners : tangents) {
        for (Tangent& tangent : corners)
            tangent.direction = Vec3(linear.direction(V3d(tangent.direction)).normalized());
        if (!linear.is_mirroring()) continue;
        for (Tangent& tangent : corners) tangent.sign = -tangent.sign;
        std::swap(corners[1], corners[2]);
    }
}

void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    std::span<const Imath::M44d> to_world) {
    for (std::size_t i = 0; i < attributes.position.size(); ++i)
        move_vertex(attributes, i, to_world[i], Linear(to_world[i]));
    for (TriangleVertices& corners : triangles) {
        if (Linear(to_world[corners[0]]).is_mirroring()) std::swap(corners[1], corners[2]);
    }
}

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const V3d twice_area = (V3d(b) - V3d(a)).cross(V3d(c) - V3d(a));
    // As in triangle_area(): an area too small for a float counts as zero.
    if (static_cast<float>(0.5 * twice_area.length()) == 0.0f) return Vec3(0);
    return Vec3(twice_area.normalized());
}

}  // namespace common::gltf
