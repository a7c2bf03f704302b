#include "shlm/layout/uv_chart.h"

#include <cmath>
#include <span>

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;
using common::Vec2;

/// Returns the mean length in the world of a unit step along u and along v, weighted by area. In double, as
/// positions may be 1e18 apart, and lightmap coordinates as near to each other as floats can be.
Imath::V2d mean_stretch(const Scene& scene, std::span<const std::uint32_t> triangles, int set) {
    Imath::V2d sum(0, 0);
    double area = 0;
    for (const std::uint32_t t : triangles) {
        const auto [a, b, c] = scene.triangle[t];
        const auto& uv = scene.texcoord[set];
        const Imath::V2d origin(uv[a]), duv1 = Imath::V2d(uv[b]) - origin, duv2 = Imath::V2d(uv[c]) - origin;
        const Imath::V3d corner(scene.position[a]), edge1 = Imath::V3d(scene.position[b]) - corner,
                                                    edge2 = Imath::V3d(scene.position[c]) - corner;
        const double determinant = duv1.x * duv2.y - duv1.y * duv2.x;
        if (determinant == 0) continue;
        const double weight = common::triangle_area(scene, t);
        sum += Imath::V2d((edge1 * duv2.y - edge2 * duv1.y).length(),
                          (edge2 * duv1.x - edge1 * duv2.x).length()) *
               (weight / std::abs(determinant));
        area += weight;
    }
    return area > 0 ? sum / area : Imath::V2d(1, 1);
}

}  // namespace

TexelChart uv_chart(const Scene& scene, const MeshInstance& instance, const LightmapUv& uv,
                    bool with_overlapping) {
    TexelChart chart;
    chart.triangle = uv.placed_triangles(instance, with_overlapping);
    const Imath::V2d stretch = mean_stretch(scene, chart.triangle, uv.texcoord_set);
    const Imath::V2d size(uv.bounds.size());
    const double aspect = (stretch.x * size.x) / (stretch.y * size.y);
    const double placed_area = uv.area - uv.collapsed.area - (with_overlapping ? 0 : uv.overlapping.area);
    const double area = placed_area / (with_overlapping ? uv.covered_fraction : uv.covered_apart);

    chart.width = std::sqrt(area * aspect);
    chart.height = std::sqrt(area / aspect);
    chart.both_faces = scene.material[instance.material].double_sided;
    chart.corner.reserve(chart.triangle.size());
    const auto in_unit_square = [&](std::uint32_t vertex) {
        return (scene.texcoord[uv.texcoord_set][vertex] - uv.bounds.min) / uv.bounds.size();
    };
    for (const std::uint32_t t : chart.triangle) {
        const auto [a, b, c] = scene.triangle[t];
        chart.corner.push_back({in_unit_square(a), in_unit_square(b), in_unit_square(c)});
    }
    return chart;
}

}  // namespace shlm
