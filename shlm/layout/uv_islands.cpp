#include "shlm/layout/uv_islands.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/core/joined_sets.h"

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;

/// Returns numbers of the instance's corners, three per triangle, equal for equal position and coordinates.
std::vector<std::uint32_t> corners_by_place(const Scene& scene, const MeshInstance& instance, int set) {
    const auto place = [&](std::uint32_t corner) {
        const std::uint32_t vertex = scene.triangle[instance.first_triangle + corner / 3][corner % 3];
        const common::Vec3& p = scene.position[vertex];
        const common::Vec2& uv = scene.texcoord[set][vertex];
        return std::tuple(uv.x, uv.y, p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(3 * std::size_t{instance.triangle_count}), number(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    for (std::size_t i = 1; i < order.size(); ++i)
        number[order[i]] = number[order[i - 1]] + (place(order[i - 1]) != place(order[i]));
    return number;
}

}  // namespace

std::vector<std::uint32_t> uv_islands(const Scene& scene, const MeshInstance& instance, int texcoord_set) {
    struct Edge {
        std::uint32_t low, high, triangle;
    };
    const std::vector<std::uint32_t> corner = corners_by_place(scene, instance, texcoord_set);
    std::vector<Edge> edges;
    edges.reserve(corner.size());
    for (std::uint32_t t = 0; t < instance.triangle_count; ++t)
        for (std::uint32_t side = 0; side < 3; ++side) {
            const auto [low, high] = std::minmax(corner[3 * t + side], corner[3 * t + (side + 1) % 3]);
            edges.push_back({low, high, t});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    common::JoinedSets joined(instance.triangle_count);
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high)
            joined.join(edges[i].triangle, edges[i - 1].triangle);
    return joined.numbers();
}

}  // namespace shlm
