// Rays aimed at vertices and edges of triangles.
#pragma once

#include "bench/experiments/stability/known_light.h"
#include "common/tracer/ray_scene.h"

namespace bench::stability {

enum class Aim { vertices, edges, anywhere };

/// Rays that start inside a closed scene.
struct AimedRays {
    common::Vec3Array origin, direction;
};

/// Returns a random point of a random triangle.
[[nodiscard]] inline common::Vec3 somewhere_on(const common::Scene& scene, Generator& generator) {
    const auto [a, b, c] = scene.triangle[generator() % scene.triangle.size()];
    const float u1 = uniform(generator), u2 = uniform(generator);
    const common::Vec2 uv = common::sample_triangle(u1, u2);
    return common::interpolate(scene.position[a], scene.position[b], scene.position[c], uv.x, uv.y);
}

/// Makes rays for a convex scene around the origin. Each starts in the inner tenth of the scene and is aimed
/// at a vertex, a point of an edge, or a point of a triangle, as precisely as a direction in floats allows.
[[nodiscard]] inline AimedRays aimed_rays(const common::Scene& scene, Aim aim, std::size_t count,
                                          Generator& generator) {
    AimedRays rays;
    rays.origin.resize(count);
    rays.direction.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const common::Vec3 origin = somewhere_on(scene, generator) * 0.1f;
        common::Vec3 target = somewhere_on(scene, generator);
        if (aim != Aim::anywhere) {
            const auto corners = scene.triangle[generator() % scene.triangle.size()];
            const std::size_t first = generator() % 3;
            const common::Vec3 &a = scene.position[corners[first]],
                               &b = scene.position[corners[(first + 1) % 3]];
            target = aim == Aim::vertices ? a : a + (b - a) * uniform(generator);
        }
        rays.origin.set(i, origin);
        rays.direction.set(i, (target - origin).normalized());
    }
    return rays;
}

/// Returns the fraction of the rays that hit nothing when traced one by one.
template <class Nearest>
[[nodiscard]] double escaped_singly(const AimedRays& rays, Nearest nearest) {
    std::size_t escaped = 0;
    for (std::size_t i = 0; i < rays.origin.x.size(); ++i)
        escaped += !nearest(rays.origin[i], rays.direction[i]);
    return static_cast<double>(escaped) / static_cast<double>(rays.origin.x.size());
}

/// Returns the same for rays traced in packets, as the tracer does.
[[nodiscard]] inline double escaped_in_packets(const AimedRays& rays, const common::RayScene& scene) {
    common::NearestSurfaces found;
    scene.nearest(rays.origin, rays.direction, found);
    const auto escaped = std::count(found.triangle.begin(), found.triangle.end(), common::no_triangle);
    return static_cast<double>(escaped) / static_cast<double>(found.triangle.size());
}

}  // namespace bench::stability
