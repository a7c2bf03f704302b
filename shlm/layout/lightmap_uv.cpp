#include "shlm/layout/lightmap_uv.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "shlm/layout/uv_islands.h"
#include "shlm/layout/uv_overlaps.h"

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;
using common::Vec2;

/// One instance's triangles, counted from its first.
struct Coordinates {
    std::vector<UvTriangle> uv;
    std::vector<double> uv_area, world_area;

    [[nodiscard]] std::size_t size() const { return uv.size(); }
};

Coordinates coordinates_of(const Scene& scene, const MeshInstance& instance, int set) {
    Coordinates coordinates;
    for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
        const auto [a, b, c] = scene.triangle[instance.first_triangle + i];
        const auto& uv = scene.texcoord[set];
        coordinates.uv.push_back({uv[a], uv[b], uv[c]});
        coordinates.uv_area.push_back(0.5 * std::abs(signed_double_area(coordinates.uv.back())));
        coordinates.world_area.push_back(common::triangle_area(scene, instance.first_triangle + i));
    }
    return coordinates;
}

/// Returns the median ratio of area in coordinates to area in the world, weighted by the latter.
double median_density(const Coordinates& of) {
    std::vector<std::pair<double, double>> by_density;  // with the world's area
    double half = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        by_density.emplace_back(of.uv_area[i] / of.world_area[i], of.world_area[i]);
        half += of.world_area[i] / 2;
    }
    std::sort(by_density.begin(), by_density.end());
    double sum = 0;
    for (const auto& [density, area] : by_density)
        if ((sum += area) >= half) return density;
    return 0;
}

std::vector<bool> find_collapsed(const Coordinates& of) {
    constexpr double least_of_median = 1e-3;
    const double least = least_of_median * median_density(of);
    std::vector<bool> collapsed(of.size());
    for (std::size_t i = 0; i < of.size(); ++i)
        collapsed[i] = of.uv_area[i] == 0 || of.uv_area[i] < least * of.world_area[i];
    return collapsed;
}

/// Returns the triangles of islands that overlap themselves, or an island of a larger area that is not among
/// these.
std::vector<bool> find_overlapping(std::span<const std::uint32_t> island, std::span<const UvOverlap> overlaps,
                                   const Coordinates& of) {
    const std::size_t islands = 1 + *std::max_element(island.begin(), island.end());
    std::vector<double> area(islands, 0);
    std::vector<std::vector<std::uint32_t>> covers(islands);
    for (std::size_t i = 0; i < of.size(); ++i) area[island[i]] += of.world_area[i];
    for (const UvOverlap& overlap : overlaps) {
        covers[island[overlap.first]].push_back(island[overlap.second]);
        covers[island[overlap.second]].push_back(island[overlap.first]);
    }

    std::vector<std::uint32_t> by_area(islands);
    std::iota(by_area.begin(), by_area.end(), 0u);
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    std::vector<bool> kept(islands, false);
    for (const std::uint32_t i : by_area)
        kept[i] = std::none_of(covers[i].begin(), covers[i].end(),
                               [&](std::uint32_t other) { return other == i || kept[other]; });
    std::vector<bool> overlapping(of.size());
    for (std::size_t i = 0; i < of.size(); ++i) overlapping[i] = !kept[island[i]];
    return overlapping;
}

UselessUv useless(const std::vector<bool>& which, const Coordinates& of, const MeshInstance& instance) {
    UselessUv result;
    for (std::uint32_t i = 0; i < which.size(); ++i) {
        if (!which[i]) continue;
        result.triangle.push_back(instance.first_triangle + i);
        result.area += of.world_area[i];
    }
    return result;
}

/// Returns the instance's area without a set of coordinates.
LightmapUv without_set(const LightmapUv& examined) {
    LightmapUv none;
    none.area = examined.area;
    return none;
}

LightmapUv examine(const Scene& scene, const MeshInstance& instance, int set) {
    Coordinates of = coordinates_of(scene, instance, set);
    LightmapUv result;
    result.texcoord_set = set;
    for (const double area : of.world_area) result.area += area;
    const std::vector<bool> collapsed = find_collapsed(of);
    result.collapsed = useless(collapsed, of, instance);
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (collapsed[i])
            of.uv[i].fill(Vec2(0, 0));  // overlaps nothing
        else
            for (const Vec2& corner : of.uv[i]) result.bounds.extendBy(corner);
    }
    const Vec2 size = result.bounds.size();
    if (result.bounds.isEmpty() || !(size.x > 0 && size.y > 0)) return without_set(result);

    const std::vector<UvOverlap> overlaps = find_uv_overlaps(of.uv);
    std::vector<double> shared(of.size(), 0);  // fraction of each triangle
    for (const UvOverlap& overlap : overlaps)
        for (const std::uint32_t i : {overlap.first, overlap.second})
            shared[i] = std::min(1.0, shared[i] + overlap.area / of.uv_area[i]);
    double covered = 0;  // a place that two triangles share counts half for each
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (collapsed[i]) continue;
        result.overlapping_area += of.world_area[i] * shared[i];
        covered += of.uv_area[i] * (1 - shared[i] / 2);
    }
    if (!overlaps.empty())
        result.overlapping =
            useless(find_overlapping(uv_islands(scene, instance, set), overlaps, of), of, instance);
    double covered_apart = covered;
    if (!result.overlapping.triangle.empty()) {
        covered_apart = 0;
        for (const std::uint32_t t : result.placed_triangles(instance, false))
            covered_apart += of.uv_area[t - instance.first_triangle];
    }
    result.covered_fraction = std::min(1.0, covered / (double{size.x} * size.y));
    result.covered_apart = std::min(1.0, covered_apart / (double{size.x} * size.y));
    return result;
}

bool is_valid_texcoord_0(const LightmapUv& uv) {
    constexpr float slack = 1e-4f;
    return uv.texcoord_set == 0 && uv.is_lightmap() && uv.overlapping.triangle.empty() &&
           uv.bounds.min.x >= -slack && uv.bounds.min.y >= -slack && uv.bounds.max.x <= 1 + slack &&
           uv.bounds.max.y <= 1 + slack;
}

LightmapUv choose(const Scene& scene, const MeshInstance& instance) {
    if (scene.material[instance.material].kind != common::SurfaceKind::diffuse) return {};
    if (instance.has_texcoord[1]) return examine(scene, instance, 1);
    LightmapUv candidate = examine(scene, instance, 0);
    if (!instance.has_texcoord[0] || !is_valid_texcoord_0(candidate)) return without_set(candidate);
    return candidate;
}

bool is_diffuse(const Scene& scene, std::size_t instance) {
    return scene.material[scene.instance[instance].material].kind == common::SurfaceKind::diffuse;
}

double diffuse_area(const Scene& scene, const std::vector<LightmapUv>& uv) {
    double total = 0;
    for (std::size_t i = 0; i < uv.size(); ++i)
        if (is_diffuse(scene, i)) total += uv[i].area;
    return total;
}

/// "1.5 m^2, 3.0 % of the diffuse surface"
std::string area_text(double area, double total) {
    return fmt::format("{:.4g} m^2, {:.1f} % of the diffuse surface", area,
                       total > 0 ? 100 * area / total : 0);
}

}  // namespace

std::vector<std::uint32_t> LightmapUv::useless_triangles() const {
    std::vector<std::uint32_t> both(collapsed.triangle.size() + overlapping.triangle.size());
    std::merge(collapsed.triangle.begin(), collapsed.triangle.end(), overlapping.triangle.begin(),
               overlapping.triangle.end(), both.begin());
    return both;
}

std::vector<std::uint32_t> LightmapUv::placed_triangles(const MeshInstance& instance,
                                                        bool with_overlapping) const {
    std::vector<std::uint32_t> all(instance.triangle_count), placed;
    std::iota(all.begin(), all.end(), instance.first_triangle);
    const std::vector<std::uint32_t> left_out = with_overlapping ? collapsed.triangle : useless_triangles();
    std::set_difference(all.begin(), all.end(), left_out.begin(), left_out.end(), std::back_inserter(placed));
    return placed;
}

bool LightmapUv::is_lightmap() const {
    return texcoord_set >= 0 && collapsed.area + overlapping.area <= area / 2 && covered_apart >= 0.1;
}

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
    double missing = 0, collapsed = 0, overlapping = 0;
    std::size_t missing_count = 0, collapsed_count = 0, overlapping_count = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        if (!is_diffuse(scene, i)) continue;
        if (uv[i].texcoord_set < 0) {
            missing += uv[i].area;
            ++missing_count;
            continue;
        }
        collapsed += uv[i].collapsed.area;
        collapsed_count += !uv[i].collapsed.triangle.empty();
        overlapping += uv[i].overlapping_area;
        overlapping_count += !uv[i].overlapping.triangle.empty();
    }
    const double total = diffuse_area(scene, uv);
    std::vector<std::string> lines;
    if (missing_count > 0)
        lines.push_back(
            fmt::format("{} of {} mesh instances have no usable lightmap coordinates: {}, get no texels; {}",
                        missing_count, uv.size(), area_text(missing, total), remedy));
    if (collapsed_count > 0)
        lines.push_back(fmt::format(
            "lightmap coordinates have next to no area in parts of {} of {} mesh instances: {}, get no "
            "texels; {}",
            collapsed_count, uv.size(), area_text(collapsed, total), remedy));
    if (overlapping_count > 0)
        lines.push_back(fmt::format(
            "lightmap coordinates overlap in {} of {} mesh instances: {}, share their texels with other "
            "surfaces; {}",
            overlapping_count, uv.size(), area_text(overlapping, total), remedy));
    return lines;
}

std::vector<std::string> describe_useless_uv(const Scene& scene, const std::vector<LightmapUv>& uv) {
    double collapsed = 0, overlapping = 0, rest = 0;
    std::size_t instances = 0;
    for (const LightmapUv& of : uv) {
        if (of.texcoord_set < 0 || (of.is_lightmap() && of.collapsed.area + of.overlapping.area == 0))
            continue;
        ++instances;
        collapsed += of.collapsed.area;
        overlapping += of.overlapping.area;
        if (!of.is_lightmap()) rest += of.area - of.collapsed.area - of.overlapping.area;
    }
    if (instances == 0) return {};
    const double total = diffuse_area(scene, uv);
    std::string text = fmt::format(
        "{} of {} mesh instances have lightmap coordinates that are no use, and texels by face there: {}",
        instances, uv.size(), area_text(collapsed + overlapping + rest, total));
    if (collapsed > 0) text += fmt::format("; {:.4g} m^2 with next to no area in coordinates", collapsed);
    if (overlapping > 0) text += fmt::format("; {:.4g} m^2 that cover other surfaces' places", overlapping);
    if (rest > 0) text += fmt::format("; {:.4g} m^2 beside these, or in rectangles that stay empty", rest);
    return {text};
}

}  // namespace shlm
