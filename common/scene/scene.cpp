#include "common/scene/scene.h"

namespace common {

float triangle_area(const Scene& scene, std::uint32_t triangle) {
    // In double, as the squares of small edges underflow a float.
    const auto& [a, b, c] = scene.triangle[triangle];
    const Imath::V3d origin(scene.position[a]);
    const Imath::V3d edge_b = Imath::V3d(scene.position[b]) - origin;
    const Imath::V3d edge_c = Imath::V3d(scene.position[c]) - origin;
    return static_cast<float>(0.5 * edge_b.cross(edge_c).length());
}

}  // namespace common
