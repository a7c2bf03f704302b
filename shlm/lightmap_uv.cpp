#include "shlm/lightmap_uv.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <cstdint>

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;
using common::Vec2;

constexpr int grid_size = 512;

/// Overlap below this part of an instance's area is rounding at chart borders.
constexpr double tolerated_overlap = 1e-3;

struct UvTriangle {
    Vec2 a, b, c;
};

UvTriangle uv_triangle(const Scene& scene, std::uint32_t triangle, int set) {
    const auto [a, b, c] = scene.triangle[triangle];
    const auto& uv = scene.texcoord[set];
    return {uv[a], uv[b], uv[c]};
}

/// Twice the signed area of (a, b, p). In double, so that the sign is right for float coordinates.
double edge(const Vec2& a, const Vec2& b, double x, double y) {
    return (double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x);
}

/// Calls `visit(cell)` for every cell of the grid over `bounds` whose centre is strictly inside the triangle:
/// centres on an edge that two triangles share belong to neither.
template <class Visit>
void for_each_covered_cell(const UvTriangle& t, const Imath::Box2f& bounds, Visit visit) {
    const Vec2 size = bounds.size();
    const auto first_cell = [&](float value, int axis) {
        return std::clamp(static_cast<int>((value - bounds.min[axis]) / size[axis] * grid_size) - 1, 0,
                          grid_size - 1);
    };
    const auto last_cell = [&](float value, int axis) {
        return std::min(first_cell(value, axis) + 2, grid_size - 1);
    };
    const double sign = edge(t.a, t.b, t.c.x, t.c.y) < 0 ? -1 : 1;
    for (int j = first_cell(std::min({t.a.y, t.b.y, t.c.y}), 1);
         j <= last_cell(std::max({t.a.y, t.b.y, t.c.y}), 1); ++j)
        for (int i = first_cell(std::min({t.a.x, t.b.x, t.c.x}), 0);
             i <= last_cell(std::max({t.a.x, t.b.x, t.c.x}), 0); ++i) {
            const double x = bounds.min.x + (i + 0.5) / grid_size * size.x;
            const double y = bounds.min.y + (j + 0.5) / grid_size * size.y;
            if (sign * edge(t.a, t.b, x, y) > 0 && sign * edge(t.b, t.c, x, y) > 0 &&
                sign * edge(t.c, t.a, x, y) > 0)
                visit(static_cast<std::size_t>(j) * grid_size + i);
        }
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
        const UvTriangle uv = uv_triangle(scene, t, set);
        for (const Vec2& corner : {uv.a, uv.b, uv.c}) result.bounds.extendBy(corner);
        result.area += common::triangle_area(scene, t);
    }
    if (!(result.bounds.size().x > 0 && result.bounds.size().y > 0)) return without_set(result);

    std::vector<std::uint8_t> users(grid_size * grid_size, 0);
    for (std::uint32_t t = instance.first_triangle; t < end; ++t)
        for_each_covered_cell(uv_triangle(scene, t, set), result.bounds,
                              [&](std::size_t cell) { users[cell] = users[cell] == 0 ? 1 : 2; });
    for (std::uint32_t t = instance.first_triangle; t < end; ++t) {
        std::size_t cells = 0, shared = 0;
        for_each_covered_cell(uv_triangle(scene, t, set), result.bounds, [&](std::size_t cell) {
            ++cells;
            shared += users[cell] > 1;
        });
        if (cells > 0)
            result.overlapping_area +=
                common::triangle_area(scene, t) * static_cast<double>(shared) / static_cast<double>(cells);
    }
    const auto covered = std::count_if(users.begin(), users.end(), [](std::uint8_t n) { return n > 0; });
    result.covered_fraction = std::max(1.0, static_cast<double>(covered)) / static_cast<double>(users.size());
    return result;
}

bool is_valid(const LightmapUv& uv) {
    constexpr float slack = 1e-4f;
    return uv.texcoord_set >= 0 && uv.bounds.min.x >= -slack && uv.bounds.min.y >= -slack &&
           uv.bounds.max.x <= 1 + slack && uv.bounds.max.y <= 1 + slack &&
           uv.overlapping_area <= tolerated_overlap * uv.area;
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
        "Lightmap Pack; xatlas)";
    double total = 0, missing = 0, overlapping = 0;
    std::size_t missing_count = 0, overlapping_count = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        if (scene.material[scene.instance[i].material].kind != common::SurfaceKind::diffuse) continue;
        total += uv[i].area;
        if (uv[i].texcoord_set < 0) {
            missing += uv[i].area;
            ++missing_count;
        } else if (uv[i].overlapping_area > tolerated_overlap * uv[i].area) {
            overlapping += uv[i].overlapping_area;
            ++overlapping_count;
        }
    }
    std::vector<std::string> lines;
    if (missing_count > 0)
        lines.push_back(fmt::format(
            "{} of {} mesh instances have no usable lightmap coordinates: {:.4g} m^2, {:.1f} % of "
            "the diffuse surface, get no texels; {}",
            missing_count, uv.size(), missing, 100 * missing / total, remedy));
    if (overlapping_count > 0)
        lines.push_back(fmt::format(
            "lightmap coordinates overlap in {} of {} mesh instances: {:.4g} m^2, {:.1f} % of the "
            "diffuse surface, share their texels with other surfaces; {}",
            overlapping_count, uv.size(), overlapping, 100 * overlapping / total, remedy));
    return lines;
}

}  // namespace shlm
