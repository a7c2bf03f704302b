// Runs the reference on scenes built in code, and compares its results.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "common/reference/reference_pass.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace tests {

using common::reference::ReferenceSums;
using Imath::V3d;

/// Returns pixels that see the points.
inline std::vector<common::VisibleSurface> as_pixels(std::span<const SurfacePoint> points) {
    std::vector<common::VisibleSurface> pixels(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        pixels[i].present = true;
        pixels[i].point = points[i];
    }
    return pixels;
}

inline ReferenceSums trace_reference(const Scene& scene, std::span<const SurfacePoint> points,
                                     std::uint64_t seed, std::uint64_t passes) {
    const common::RayScene rays(scene);
    const common::reference::Lights lights(scene);
    const auto pixels = as_pixels(points);
    ReferenceSums sums(points.size());
    while (sums.passes < passes) add_pass(rays, lights, pixels, seed, sums, [](std::size_t) { return true; });
    return sums;
}

inline double estimate(const ReferenceSums& sums, std::size_t point, int channel) {
    return sums.pixel[point][channel].mean().value();
}

inline double variance(const ReferenceSums& sums, std::size_t point, int channel) {
    return sums.pixel[point][channel].variance().value();
}

/// Rays start and end a few millionths of the scene's size off its surfaces, which steep falloffs magnify.
inline constexpr double rounding = 1e-4;

/// Expects every point to be as close to the expected value as its own variance allows, and also the mean
/// over all points. Each of the two fails by chance with probability 1e-5 in all. Needs an odd number of
/// passes.
inline void expect_irradiance(const ReferenceSums& sums, std::span<const V3d> expected) {
    constexpr double alpha = 1e-5;
    const auto count = static_cast<double>(expected.size());
    const double t = t_for(alpha / (3 * count), static_cast<int>(sums.passes) - 1);
    EXPECT_EQ(sums.dropped, 0u);
    for (int c = 0; c < 3; ++c) {
        double mean = 0, mean_expected = 0, variances = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(estimate(sums, i, c), expected[i][c],
                        t * std::sqrt(variance(sums, i, c)) + rounding * expected[i][c])
                << "point " << i << ", channel " << c;
            mean += estimate(sums, i, c) / count;
            mean_expected += expected[i][c] / count;
            variances += variance(sums, i, c);
        }
        EXPECT_NEAR(mean, mean_expected,
                    z_for(alpha / 3) * std::sqrt(variances) / count + rounding * mean_expected)
            << "mean of channel " << c;
    }
}

inline void expect_irradiance(const ReferenceSums& sums, std::span<const double> expected) {
    std::vector<V3d> channels;
    for (const double e : expected) channels.emplace_back(e, e, e);
    expect_irradiance(sums, std::span<const V3d>(channels));
}

/// Returns the irradiance at `position` for `normal` from a polygon of radiance 1 above the horizon (Lambert,
/// "Photometria", 1760): half the sum over its edges of the angle they subtend, projected.
inline double lambert(const std::vector<Vec3>& corners, const Vec3& position, const Vec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const V3d a = (V3d(corners[i]) - V3d(position)).normalized();
        const V3d b = (V3d(corners[(i + 1) % corners.size()]) - V3d(position)).normalized();
        sum += std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * a.cross(b).normalized().dot(V3d(normal));
    }
    return std::abs(sum) / 2;
}

/// A triangle that light reaches, and the side.
struct LitFace {
    std::uint32_t triangle;
    bool from_back = false;
};

/// Returns a point on one of the faces, uniform by area, with its triangle's normal as shading normal, so
/// that its irradiance is flux per area.
inline SurfacePoint random_point(const Scene& scene, std::span<const LitFace> faces, std::mt19937& engine) {
    std::vector<double> areas;
    for (const LitFace& face : faces)
        areas.push_back(static_cast<double>(common::triangle_area(scene, face.triangle)));
    const auto [triangle, from_back] =
        faces[std::discrete_distribution<std::size_t>(areas.begin(), areas.end())(engine)];
    std::uniform_real_distribution<float> uniform(0, 1);
    float u = uniform(engine), v = uniform(engine);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Vec3& normal = scene.geometric_normal[triangle];
    SurfacePoint point = common::surface_point_at(scene, {triangle, u, v}, from_back ? normal : -normal);
    point.shading_normal = point.geometric_normal;
    return point;
}

inline std::vector<LitFace> fronts(std::uint32_t first, std::uint32_t count) {
    std::vector<LitFace> faces;
    for (std::uint32_t t = first; t < first + count; ++t) faces.push_back({t});
    return faces;
}

/// Returns the mean irradiance over the faces in the red channel, from one pass at each of `count` random
/// points.
inline Sample mean_irradiance(const Scene& scene, std::span<const LitFace> faces, std::size_t count) {
    constexpr std::uint64_t seed = 1;
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(scene, faces, engine));
    const ReferenceSums sums = trace_reference(scene, points, seed, 1);
    Sample sample;
    for (std::size_t i = 0; i < count; ++i) sample.add(estimate(sums, i, 0));
    return sample;
}

/// Checks the energy balance of a closed room of one albedo. What arrives on all faces is the light's power
/// and what they reflect of it, whatever the shape: the mean irradiance is power / (area (1 - albedo)). Fails
/// by chance with probability 1e-5.
inline void expect_closed_room(const Scene& scene, std::span<const LitFace> faces, double power,
                               double albedo, std::size_t count) {
    double area = 0;
    for (const LitFace& face : faces)
        area += static_cast<double>(common::triangle_area(scene, face.triangle));
    const double expected = power / (area * (1 - albedo));
    const Sample sample = mean_irradiance(scene, faces, count);
    EXPECT_NEAR(sample.mean(), expected, z_for(1e-5) * sample.standard_error() + rounding * expected);
    EXPECT_LT(sample.standard_error(), 0.03 * expected);
}

}  // namespace tests
