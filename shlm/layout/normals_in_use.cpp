#include "shlm/layout/normals_in_use.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"

namespace shlm {
namespace {

using common::Scene;
using common::Vec3;

constexpr std::size_t samples = 32;  // per region

struct RegionSurface {
    std::vector<std::uint32_t> triangle;
    std::vector<double> area_before;  ///< cumulative, each triangle included
};

/// Returns one surface for each region.
std::vector<RegionSurface> surfaces_of(const Scene& scene, const TexelLayout& layout) {
    std::vector<RegionSurface> surfaces(layout.regions().size());
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        if (layout.triangle(t).width == 0) continue;
        RegionSurface& surface = surfaces[layout.region_of(t)];
        const double before = surface.area_before.empty() ? 0 : surface.area_before.back();
        surface.triangle.push_back(t);
        surface.area_before.push_back(before + double{common::triangle_area(scene, t)});
    }
    return surfaces;
}

/// Returns the shading normal in the frame of the geometric normal.
Vec3 bent_normal(const Scene& scene, const common::SurfaceId& surface) {
    const Vec3 front = scene.geometric_normal[surface.triangle];
    const Vec3 shading = common::surface_point_at(scene, surface, -front).shading_normal;
    const common::Frame frame(front);
    return {frame.tangent.dot(shading), frame.bitangent.dot(shading), front.dot(shading)};
}

NormalsInUse normals_of(const Scene& scene, const RegionSurface& surface) {
    NormalsInUse normals;
    for (std::size_t i = 0; i < samples && !surface.triangle.empty(); ++i) {
        const double at = (static_cast<double>(i) + 0.5) / samples * surface.area_before.back();
        const auto found = std::upper_bound(surface.area_before.begin(), surface.area_before.end() - 1, at);
        const auto triangle = surface.triangle[static_cast<std::size_t>(found - surface.area_before.begin())];
        // The additive sequence of the plastic number (Roberts 2018), folded into the triangle.
        const auto along = [&](double step) {
            const double x = 0.5 + step * static_cast<double>(i + 1);
            return static_cast<float>(x - std::floor(x));
        };
        float u = along(0.7548776662), v = along(0.5698402910);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        normals.bent.push_back(bent_normal(scene, {triangle, u, v}));
    }
    const bool straight = std::all_of(normals.bent.begin(), normals.bent.end(),
                                      [](const Vec3& normal) { return normal.z > straight_cosine; });
    if (straight) normals.bent.clear();
    return normals;
}

}  // namespace

std::vector<NormalsInUse> normals_in_use(const Scene& scene, const TexelLayout& layout) {
    const std::vector<RegionSurface> surfaces = surfaces_of(scene, layout);
    std::vector<NormalsInUse> normals(surfaces.size());
    tbb::parallel_for(std::size_t{0}, surfaces.size(),
                      [&](std::size_t r) { normals[r] = normals_of(scene, surfaces[r]); });
    return normals;
}

}  // namespace shlm
