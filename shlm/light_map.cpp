#include "shlm/light_map.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

using common::Rgb;
using common::Vec3;

std::vector<std::size_t> covered_texels(std::span<const TexelGeometry> geometry) {
    std::vector<std::size_t> covered;
    for (std::size_t i = 0; i < geometry.size(); ++i)
        if (geometry[i].area > 0) covered.push_back(i);
    covered.shrink_to_fit();
    return covered;
}

std::vector<Vec3> centers_of(std::span<const TexelGeometry> geometry) {
    std::vector<Vec3> centers;
    for (std::size_t i : covered_texels(geometry)) centers.push_back(geometry[i].center);
    centers.shrink_to_fit();
    return centers;
}

Texel finished_texel(const TexelSum& sum, const TexelGeometry& geometry, float watts_per_flux) {
    Texel texel{geometry.normal, geometry.area, {}};
    const double scale = static_cast<double>(watts_per_flux) / geometry.area;
    for (std::size_t i = 0; i < coefficient_count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            texel.irradiance[i][static_cast<int>(c)] =
                static_cast<float>(sum.coefficient[3 * i + c] * scale * cosine_factors[i]);
    return texel;
}

std::vector<Texel> finished_texels(const TexelSums& sums, std::span<const TexelGeometry> geometry,
                                   float watts_per_flux) {
    const std::vector<std::size_t> covered = covered_texels(geometry);
    std::vector<Texel> texels(covered.size());
    tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t i) {
        texels[i] = finished_texel(sums[covered[i]], geometry[covered[i]], watts_per_flux);
    });
    return texels;
}

/// Four widths of the largest texel: every point of the surface has a texel of its own that near.
float gather_radius(std::span<const Texel> texels) {
    float largest = 0;
    for (const Texel& texel : texels) largest = std::max(largest, texel.area);
    return 4 * std::sqrt(largest);
}

Rgb evaluate(const Texel& texel, const ShValues& y) {
    Rgb sum(0, 0, 0);
    for (std::size_t i = 0; i < coefficient_count; ++i) sum += texel.irradiance[i] * y[i];
    return sum;
}

}  // namespace

Rgb evaluate_irradiance(const Texel& texel, const Vec3& normal) {
    return evaluate(texel, evaluate_sh(normal));
}

LightMap::LightMap(const TexelSums& sums, std::span<const TexelGeometry> geometry, float watts_per_flux,
                   std::size_t nearest)
    : centers_(centers_of(geometry)),
      texels_(finished_texels(sums, geometry, watts_per_flux)),
      index_(centers_),
      nearest_(nearest),
      max_radius_(gather_radius(texels_)) {}

Rgb LightMap::irradiance(const common::SurfacePoint& point) const {
    static thread_local std::vector<common::Neighbour> neighbours;  // a gather must not allocate
    neighbours.resize(nearest_);
    common::NearestSet nearest(neighbours, max_radius_ * max_radius_);
    index_.search(point.position, nearest, [&](std::uint32_t i) {
        return texels_[i].normal.dot(point.geometric_normal) > common::same_surface_cosine;
    });
    // All texels are asked for the same normal: one evaluation of the harmonics serves them.
    const ShValues y = evaluate_sh(point.shading_normal);
    Rgb sum(0, 0, 0);
    float projected_area = 0;
    for (const common::Neighbour& neighbour : nearest.found()) {
        const Texel& texel = texels_[neighbour.index];
        const float weight = texel.area * texel.normal.dot(point.geometric_normal);
        sum += evaluate(texel, y) * weight;
        projected_area += weight;
    }
    if (projected_area == 0) return Rgb(0, 0, 0);
    sum /= projected_area;
    return {std::max(sum.x, 0.0f), std::max(sum.y, 0.0f), std::max(sum.z, 0.0f)};
}

}  // namespace shlm
