#include "common/reference/light.h"

#include <numbers>

#include "common/scene/coverage.h"

namespace common::reference {
namespace {

using Imath::V3d;
using std::numbers::pi;

/// Mean over a grid, and at least a hundredth of the radiance without texture and holes: the grid may miss
/// what is bright.
double mean_radiance(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    const CoverageRange coverage = coverage_range(scene, triangle);
    const double everywhere = mean_channel(material.emitted_radiance) * static_cast<double>(coverage.most);
    if (material.emissive_texture.texture == no_texture && coverage.least == coverage.most) return everywhere;
    constexpr int across = 12;
    double sum = 0;
    for (int i = 0; i < across * across; ++i) {
        const SurfaceId place =
            place_on(triangle, {(i % across + 0.5) / across, (i / across + 0.5) / across});
        sum +=
            mean_channel(emitted_radiance_at(scene, place)) * static_cast<double>(coverage_at(scene, place));
    }
    return std::max(sum / (across * across), 0.01 * everywhere);
}

double power(const AreaLight& light, double) {
    return light.mean_radiance * pi * light.area * (light.both_faces ? 2 : 1);
}
double power(const PointLight& light, double) {
    return 4 * pi * mean_channel(light.intensity);
}
/// The falloff integrates to 2 pi (1 - inner + (inner - outer) / 3) over directions.
double power(const SpotLight& light, double) {
    const double inner = static_cast<double>(light.cos_inner_angle);
    const double outer = static_cast<double>(light.cos_outer_angle);
    return 2 * pi * mean_channel(light.intensity) * (1 - inner + (inner - outer) / 3);
}
double power(const DirectionalLight& light, double scene_radius) {
    return mean_channel(light.irradiance) * pi * scene_radius * scene_radius;
}

}  // namespace

AreaLight area_light(const Scene& scene, std::uint32_t triangle) {
    const auto [a, b, c] = scene.triangle[triangle];
    const std::array<V3d, 3> corner = {V3d(scene.position[a]), V3d(scene.position[b]),
                                       V3d(scene.position[c])};
    const V3d twice_area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const V3d center = (corner[0] + corner[1] + corner[2]) / 3;
    double radius = 0;
    for (const V3d& place : corner) radius = std::max(radius, (place - center).length());
    return {triangle,
            scene.material_of(triangle).double_sided,
            0.5 * twice_area.length(),
            mean_radiance(scene, triangle),
            corner,
            V3d(scene.geometric_normal[triangle]),
            center,
            radius};
}

SurfaceId place_on(std::uint32_t triangle, const std::array<double, 2>& square) {
    const bool beyond = square[0] + square[1] > 1;
    const double u = beyond ? 1 - square[0] : square[0], v = beyond ? 1 - square[1] : square[1];
    return {triangle, static_cast<float>(u), static_cast<float>(v)};
}

double power_of(const Light& light, double scene_radius) {
    return std::visit([&](const auto& l) { return power(l, scene_radius); }, light);
}

}  // namespace common::reference
