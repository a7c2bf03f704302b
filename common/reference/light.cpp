#include "common/reference/light.h"

#include <numbers>
#include <numeric>

#include "common/scene/coverage.h"

namespace common::reference {
namespace {

using Imath::V3d;
using std::numbers::pi;

/// The mean radiance of a triangle, and how its places are sampled.
struct Emission {
    double mean_radiance;
    std::shared_ptr<const BrightPlaces> places;
};

Emission emission_of(const Scene& scene, std::uint32_t triangle, int most_cells_across) {
    const Material& material = scene.material_of(triangle);
    const CoverageRange coverage = coverage_range(scene, triangle);
    const double everywhere = mean_channel(material.emitted_radiance) * static_cast<double>(coverage.most);
    const bool is_textured = material.emissive_texture.texture != no_texture;
    if (!is_textured && coverage.least == coverage.most) return {everywhere, nullptr};
    constexpr int across_holes = 16;
    const int across = is_textured ? cells_across(scene, triangle, most_cells_across)
                                   : std::min(across_holes, most_cells_across);
    std::vector<double> cells = emission_grid(scene, triangle, across);
    const double mean = std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
    constexpr double least_share = 0.01;  // the grid may have missed what is bright
    if (!(mean > 0)) return {coverage.least == coverage.most ? 0 : least_share * everywhere, nullptr};
    for (double& cell : cells) cell = std::max(cell, least_share * mean);
    return {mean, std::make_shared<const BrightPlaces>(across, std::move(cells))};
}

double power(const AreaLight& light, double) {
    return light.mean_radiance * pi * light.area * (light.both_faces ? 2 : 1);
}
double power(const PointLight& light, double) {
    return 4 * pi * mean_channel(light.intensity);
}
/// The falloff integrates to 2 pi (1 - inner + (inner - outer) / 3) over directions.
double power(const SpotLight& light, double) {
    const double inner = light.cos_inner_angle, outer = light.cos_outer_angle;
    return 2 * pi * mean_channel(light.intensity) * (1 - inner + (inner - outer) / 3);
}
double power(const DirectionalLight& light, double scene_radius) {
    return mean_channel(light.irradiance) * pi * scene_radius * scene_radius;
}

}  // namespace

AreaLight area_light(const Scene& scene, std::uint32_t triangle, int most_cells_across) {
    const auto [a, b, c] = scene.triangle[triangle];
    const std::array<V3d, 3> corner = {V3d(scene.position[a]), V3d(scene.position[b]),
                                       V3d(scene.position[c])};
    const V3d twice_area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const V3d center = (corner[0] + corner[1] + corner[2]) / 3;
    double radius = 0;
    for (const V3d& place : corner) radius = std::max(radius, (place - center).length());
    Emission emission = emission_of(scene, triangle, most_cells_across);
    return {triangle,
            scene.material_of(triangle).double_sided,
            0.5 * twice_area.length(),
            emission.mean_radiance,
            std::move(emission.places),
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
