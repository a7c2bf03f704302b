#include "common/gltf/far_places.h"

#include <cmath>
#include <limits>

namespace common::gltf {
namespace {

using Imath::V3d;

/// Returns the largest absolute coordinate.
double distance_of(const Imath::Box3f& bounds) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const float coordinate : {bounds.min[axis], bounds.max[axis]})
            largest = std::max(largest, std::abs(static_cast<double>(coordinate)));
    return largest;
}

double diagonal_of(const Imath::Box3f& bounds) {
    return (V3d(bounds.max) - V3d(bounds.min)).length();
}

}  // namespace

V3d origin_for(const Imath::Box3f& bounds) {
    constexpr double far_in_diagonals = 256;
    const double diagonal = diagonal_of(bounds);
    if (bounds.isEmpty() || distance_of(bounds) <= far_in_diagonals * diagonal) return V3d(0);
    const V3d center = 0.5 * (V3d(bounds.min) + V3d(bounds.max));
    // A multiple of a power of two is exact in double and easy to add.
    const double step = diagonal > 0 ? std::exp2(std::floor(std::log2(diagonal))) : 1.0;
    return {std::round(center.x / step) * step, std::round(center.y / step) * step,
            std::round(center.z / step) * step};
}

void move_origin(const V3d& origin, std::span<PlacedNode> nodes) {
    for (PlacedNode& node : nodes)
        for (int axis = 0; axis < 3; ++axis) node.to_world[3][axis] -= origin[axis];
}

void warn_about_far_instances(const Scene& scene, Warnings& warnings) {
    constexpr double ulps_off_surfaces = 16, least_part = 1.0 / 64;
    for (const MeshInstance& instance : scene.instance) {
        Imath::Box3f bounds;
        for (std::uint32_t t = 0; t < instance.triangle_count; ++t)
            for (const std::uint32_t corner : scene.triangle[instance.first_triangle + t])
                bounds.extendBy(scene.position[corner]);
        const double blur = distance_of(bounds) * ulps_off_surfaces * std::numeric_limits<float>::epsilon();
        if (blur > least_part * diagonal_of(bounds))
            warnings.add("too far from the rest of the scene for its size: floats blur it", instance.name);
    }
}

}  // namespace common::gltf
