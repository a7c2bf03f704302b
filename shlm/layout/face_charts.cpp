#include "shlm/layout/face_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "shlm/layout/flat_patches.h"

namespace shlm {
namespace {

using common::Scene;
using Imath::V2d;
using Imath::V3d;

constexpr double least_covered = 0.5;

V3d corner_of(const Scene& scene, std::uint32_t triangle, std::size_t corner) {
    return V3d(scene.position[scene.triangle[triangle][corner]]);
}

/// Two perpendicular unit directions in a plane, and an interval along each.
struct Rectangle {
    V3d right, down;
    V2d least, most;

    [[nodiscard]] V2d place(const V3d& position) const { return {position.dot(right), position.dot(down)}; }
    [[nodiscard]] V2d size() const { return most - least; }
    [[nodiscard]] double area() const { return size().x * size().y; }

    /// Returns the corner at `least`, at the same height above the origin as the position.
    [[nodiscard]] V3d corner_level_with(const V3d& position) const {
        const V2d along = least - place(position);
        return position + right * along.x + down * along.y;
    }
};

Rectangle rectangle_along(const Scene& scene, const FlatPatch& patch, const V3d& edge) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const V3d normal(patch.normal);
    const V3d right = (edge - normal * edge.dot(normal)).normalized();
    Rectangle rectangle{right, normal.cross(right), V2d(infinity), V2d(-infinity)};
    for (const std::uint32_t triangle : patch.triangle)
        for (std::size_t i = 0; i < 3; ++i) {
            const V2d at = rectangle.place(corner_of(scene, triangle, i));
            for (int axis = 0; axis < 2; ++axis) {
                rectangle.least[axis] = std::min(rectangle.least[axis], at[axis]);
                rectangle.most[axis] = std::max(rectangle.most[axis], at[axis]);
            }
        }
    return rectangle;
}

/// Returns the smallest of the rectangles along an edge of the largest triangle. A single triangle covers
/// half of it. A rectangular wall covers all of it if that triangle has an edge on its border or parallel to
/// it.
Rectangle rectangle_around(const Scene& scene, const FlatPatch& patch) {
    const std::uint32_t largest = *std::max_element(patch.triangle.begin(), patch.triangle.end(),
                                                    [&](std::uint32_t a, std::uint32_t b) {
                                                        return std::pair(common::triangle_area(scene, a), b) <
                                                               std::pair(common::triangle_area(scene, b), a);
                                                    });
    Rectangle smallest;
    for (std::size_t i = 0; i < 3; ++i) {
        const V3d edge = corner_of(scene, largest, (i + 1) % 3) - corner_of(scene, largest, i);
        const Rectangle rectangle = rectangle_along(scene, patch, edge);
        if (i == 0 || rectangle.area() < smallest.area()) smallest = rectangle;
    }
    return smallest;
}

/// Returns the area of the triangles, projected to the patch's plane.
double covered_area(const Scene& scene, const FlatPatch& patch) {
    double area = 0;
    for (const std::uint32_t triangle : patch.triangle)
        area += common::triangle_area(scene, triangle) * scene.geometric_normal[triangle].dot(patch.normal);
    return area;
}

V3d center_of(const Scene& scene, std::uint32_t triangle) {
    return (corner_of(scene, triangle, 0) + corner_of(scene, triangle, 1) + corner_of(scene, triangle, 2)) /
           3;
}

/// Halves a patch, along the longer side of its rectangle, until its parts fill theirs.
void divide(const Scene& scene, FlatPatch patch, double texel_size, std::vector<FlatPatch>& filled) {
    const Rectangle rectangle = rectangle_around(scene, patch);
    const bool is_small = rectangle.area() <= texel_size * texel_size;
    if (patch.triangle.size() == 1 || is_small ||
        covered_area(scene, patch) >= least_covered * rectangle.area()) {
        filled.push_back(std::move(patch));
        return;
    }
    const V3d along = rectangle.size().x > rectangle.size().y ? rectangle.right : rectangle.down;
    const auto place = [&](std::uint32_t triangle) {
        return std::pair(center_of(scene, triangle).dot(along), triangle);
    };
    const auto begin = patch.triangle.begin(), end = patch.triangle.end();
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    divide(scene, {patch.normal, {begin, middle}}, texel_size, filled);
    divide(scene, {patch.normal, {middle, end}}, texel_size, filled);
}

/// Returns the cube of the texel's size that contains a patch, if it is smaller than half a texel each way.
std::optional<std::array<double, 3>> cube_of(const Scene& scene, const FlatPatch& patch, double texel_size) {
    const V2d size = rectangle_around(scene, patch).size();
    if (std::max(size.x, size.y) > texel_size / 2) return std::nullopt;
    const V3d center = center_of(scene, patch.triangle.front()) / texel_size;
    return std::array{std::floor(center.x), std::floor(center.y), std::floor(center.z)};
}

/// Joins small patches of one cube that face the same way.
std::vector<FlatPatch> shared(const Scene& scene, std::vector<FlatPatch> patches, double texel_size) {
    std::vector<FlatPatch> kept;
    std::map<std::array<double, 3>, std::vector<std::size_t>> in_cube;  // indices into `kept`
    for (FlatPatch& patch : patches) {
        const auto cube = cube_of(scene, patch, texel_size);
        if (!cube) {
            kept.push_back(std::move(patch));
            continue;
        }
        std::vector<std::size_t>& hosts = in_cube[*cube];
        const auto host = std::find_if(hosts.begin(), hosts.end(), [&](std::size_t i) {
            return kept[i].normal.dot(patch.normal) >= same_patch_cosine;
        });
        if (host == hosts.end()) {
            hosts.push_back(kept.size());
            kept.push_back(std::move(patch));
        } else {
            std::vector<std::uint32_t>& joined = kept[*host].triangle;
            joined.insert(joined.end(), patch.triangle.begin(), patch.triangle.end());
        }
    }
    return kept;
}

TexelChart laid_flat(const Scene& scene, const FlatPatch& patch, const Rectangle& rectangle,
                     bool both_faces) {
    TexelChart chart;
    chart.width = rectangle.size().x;
    chart.height = rectangle.size().y;
    chart.both_faces = both_faces;
    chart.plane = {rectangle.corner_level_with(corner_of(scene, patch.triangle.front(), 0)), rectangle.right,
                   rectangle.down};
    chart.triangle = patch.triangle;
    std::sort(chart.triangle.begin(), chart.triangle.end());
    for (const std::uint32_t triangle : chart.triangle) {
        auto& corners = chart.corner.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const V2d at = rectangle.place(corner_of(scene, triangle, i)) - rectangle.least;
            corners[i] = common::Vec2(at / rectangle.size());
        }
    }
    return chart;
}

}  // namespace

std::vector<TexelChart> face_charts(const Scene& scene, std::span<const std::uint32_t> triangles,
                                    bool both_faces, double texel_size) {
    std::vector<FlatPatch> patches;
    for (FlatPatch& patch : flat_patches(scene, triangles, texel_size))
        divide(scene, std::move(patch), texel_size, patches);

    std::vector<TexelChart> charts;
    for (const FlatPatch& patch : shared(scene, std::move(patches), texel_size)) {
        const Rectangle rectangle = rectangle_around(scene, patch);
        // Slivers can be thinner than the rounding of their positions, and then have no area.
        if (rectangle.area() > 0) charts.push_back(laid_flat(scene, patch, rectangle, both_faces));
    }
    return charts;
}

}  // namespace shlm
