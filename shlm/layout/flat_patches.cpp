#include "shlm/layout/flat_patches.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace shlm {
namespace {

using common::Scene;
using common::Vec3;

/// Triangles of the scene. Below, a triangle's number is its index in this list.
using Triangles = std::span<const std::uint32_t>;

constexpr std::uint32_t none = 0xffffffff;

/// Returns numbers of the triangles' corners, three each, equal for equal positions. Files repeat vertices
/// where normals or texture coordinates differ.
std::vector<std::uint32_t> corners_by_position(const Scene& scene, Triangles triangles) {
    const auto position = [&](std::uint32_t corner) -> const Vec3& {
        return scene.position[scene.triangle[triangles[corner / 3]][corner % 3]];
    };
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 &p = position(a), &q = position(b);
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::vector<std::uint32_t> order(3 * triangles.size()), number(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), before);
    for (std::size_t i = 1; i < order.size(); ++i)
        number[order[i]] = number[order[i - 1]] + before(order[i - 1], order[i]);
    return number;
}

/// The triangle behind each edge of a triangle, or `none`. If an edge has more than two triangles, they are
/// paired in the file's order.
using Neighbours = std::array<std::uint32_t, 3>;

std::vector<Neighbours> find_neighbours(const Scene& scene, Triangles triangles) {
    struct Edge {
        std::uint32_t low, high, triangle, side;
    };
    const std::vector<std::uint32_t> corner = corners_by_position(scene, triangles);
    std::vector<Edge> edges;
    edges.reserve(corner.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t side = 0; side < 3; ++side) {
            const auto [low, high] = std::minmax(corner[3 * t + side], corner[3 * t + (side + 1) % 3]);
            if (low != high) edges.push_back({low, high, t, side});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });

    std::vector<Neighbours> neighbours(triangles.size(), {none, none, none});
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const Edge &a = edges[i], &b = edges[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        neighbours[a.triangle][a.side] = b.triangle;
        neighbours[b.triangle][b.side] = a.triangle;
        ++i;
    }
    return neighbours;
}

/// Returns the triangles that have an area, the largest first.
std::vector<std::uint32_t> by_area(const Scene& scene, Triangles triangles) {
    std::vector<float> area(triangles.size());
    std::vector<std::uint32_t> order;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        area[t] = common::triangle_area(scene, triangles[t]);
        if (area[t] > 0) order.push_back(t);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    return order;
}

}  // namespace

std::vector<FlatPatch> flat_patches(const Scene& scene, Triangles triangles, double texel_size) {
    const std::vector<Neighbours> neighbours = find_neighbours(scene, triangles);
    const std::vector<std::uint32_t> seeds = by_area(scene, triangles);
    std::vector<bool> free(triangles.size(), false);
    for (const std::uint32_t t : seeds) free[t] = true;

    const auto near_plane_of = [&](std::uint32_t seed, std::uint32_t triangle) {
        const Vec3& normal = scene.geometric_normal[seed];
        if (scene.geometric_normal[triangle].dot(normal) < same_patch_cosine) return false;
        const Imath::V3d on_plane(scene.position[scene.triangle[seed][0]]);
        return std::all_of(scene.triangle[triangle].begin(), scene.triangle[triangle].end(),
                           [&](std::uint32_t vertex) {
                               const Imath::V3d offset = Imath::V3d(scene.position[vertex]) - on_plane;
                               return std::abs(offset.dot(Imath::V3d(normal))) <= texel_size / 2;
                           });
    };

    std::vector<FlatPatch> patches;
    for (const std::uint32_t seed : seeds) {
        if (!free[seed]) continue;
        free[seed] = false;
        std::vector<std::uint32_t> taken = {seed};
        for (std::size_t i = 0; i < taken.size(); ++i)
            for (const std::uint32_t next : neighbours[taken[i]]) {
                if (next == none || !free[next]) continue;
                if (!near_plane_of(triangles[seed], triangles[next])) continue;
                free[next] = false;
                taken.push_back(next);
            }
        for (std::uint32_t& triangle : taken) triangle = triangles[triangle];
        patches.push_back({scene.geometric_normal[triangles[seed]], std::move(taken)});
    }
    return patches;
}

}  // namespace shlm
