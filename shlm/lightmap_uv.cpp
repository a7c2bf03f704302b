#include "shlm/lightmap_uv.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <cstdint>

#include "shlm/coverage_grid.h"

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;
using common::Vec2;

UvTriangle uv_triangle(const Scene& scene, std::uint32_t triangle, int set) {
    const auto [a, b, c] = scene.triangle[triangle];
    const auto& uv = scene.texcoord[set];
    return {uv[a], uv[b], uv[c]};
}

double area_of(const UvTriangle& t) {
    const Vec2 ab = t[1] - t[0], ac = t[2] - t[0];
    return 0.5 * std::abs(double{ab.x} * ac.y - double{ab.y} * ac.x);
}

/// The instance's area, and nothing to place it by.
LightmapUv without_set(const LightmapUv& examined) {
    LightmapUv none;
    none.area = examined.area;
    return none;
}

LightmapUv examine(const Scene& scene, const MeshInstance& instance, int set) {
    LightmapUv result;
    result.texcoord_set = set;
    const std::uint32_t end = instance.first_triangle + instance.triangle_count;
    for (std::uint32_t t = instance.first_triangle; t < end; ++t) {
        for (const Vec2& corner : uv_triangle(scene, t, set)) result.bounds.extendBy(corner);
        result.area += common::triangle_area(scene, t);
    }
    const Vec2 size = result.bounds.size();
    if (!(size.x > 0 && size.y > 0)) return without_set(result);

    CoverageGrid grid(result.bounds, instance.triangle_count);
    for (std::uint32_t t = instance.first_triangle; t < end; ++t) grid.add(uv_triangle(scene, t, set));
    double covered = 0;  // a place that two triangles share is half each one's
    for (std::uint32_t t = instance.first_triangle; t < end; ++t) {
        const UvTriangle uv = uv_triangle(scene, t, set);
        const double shared = grid.shared_part(uv);
        result.overlapping_area += common::triangle_area(scene, t) * shared;
        covered += area_of(uv) * (1 - shared / 2);
    }
    if (covered == 0) return without_set(result);
    result.covered_fraction = std::min(1.0, covered / (double{size.x} * size.y));
    return result;
}

bool is_valid(const LightmapUv& uv) {
    constexpr float slack = 1e-4f;
    return uv.texcoord_set >= 0 && uv.bounds.min.x >= -slack && uv.bounds.min.y >= -slack &&
           uv.bounds.max.x <= 1 + slack && uv.bounds.max.y <= 1 + slack &&
           !uv.overlaps();
}

LightmapUv choose(const Scene& scene, const MeshInstance& instance) {
    if (scene.material[instance.material].kind != common::SurfaceKind::diffuse) return {};
    if (instance.has_texcoord[1]) return examine(scene, instance, 1);
    LightmapUv candidate = examine(scene, instance, 0);
    if (!instance.has_texcoord[0] || !is_valid(candidate)) return without_set(candidate);
    return candidate;
}

}  // namespace

std::vector<LightmapUv> find_lightmap_uv(const Scene& scene) {
    std::vector<LightmapUv> uv(scene.instance.size());
    tbb::parallel_for(std::size_t{0}, uv.size(),
                      [&](std::size_t i) { uv[i] = choose(scene, scene.instance[i]); });
    return uv;
}

std::vector<std::string> describe_lightmap_trouble(const Scene& scene, const std::vector<LightmapUv>& uv) {
    constexpr const char* remedy =
        "make lightmap coordinates with an unwrapping tool that writes TEXCOORD_1 (Blender: a second UV map, "
        "UV > "
        "Lightmap Pack; xatlas), or have texels laid by face";
    double total = 0, missing = 0, overlapping = 0;
    std::size_t missing_count = 0, overlapping_count = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        if (scene.material[scene.instance[i].material].kind != common::SurfaceKind::diffuse) continue;
        total += uv[i].area;
        if (uv[i].texcoord_set < 0) {
            missing += uv[i].area;
            ++missing_count;
        } else if (uv[i].overlaps()) {
            overlapping += uv[i].overlapping_area;
            ++overlapping_count;
        }
    }
    const auto percent = [&](double area) { return total > 0 ? 100 * area / total : 0; };
    std::vector<std::string> lines;
    if (missing_count > 0)
        lines.push_back(fmt::format(
            "{} of {} mesh instances have no usable lightmap coordinates: {:.4g} m^2, {:.1f} % of "
            "the diffuse surface, get no texels; {}",
            missing_count, uv.size(), missing, percent(missing), remedy));
    if (overlapping_count > 0)
        lines.push_back(fmt::format(
            "lightmap coordinates overlap in {} of {} mesh instances: {:.4g} m^2, {:.1f} % of the "
            "diffuse surface, share their texels with other surfaces; {}",
            overlapping_count, uv.size(), overlapping, percent(overlapping), remedy));
    return lines;
}

}  // namespace shlm
