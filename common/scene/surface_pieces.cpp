#include "common/scene/surface_pieces.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <bit>
#include <numeric>
#include <tuple>
#include <utility>

#include "common/core/joined_sets.h"

namespace common {
namespace {

/// An edge of a triangle between two vertices that are numbered by position.
struct Edge {
    std::uint64_t ends;  ///< the lower number in the upper half
    std::uint32_t triangle;
    bool upward;  ///< the triangle's winding goes from the lower number to the higher

    friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// Returns numbers of the scene's vertices, equal for equal positions. Files repeat vertices where normals or
/// texture coordinates differ, and meshes that meet each have their own.
std::vector<std::uint32_t> vertices_by_position(const Scene& scene) {
    struct Place {
        std::uint32_t x, y, z, vertex;
    };
    std::vector<Place> places(scene.position.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const Vec3& p = scene.position[i];
        // Adding 0 turns -0 into 0, to which it is equal.
        places[i] = {std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
                     std::bit_cast<std::uint32_t>(p.z + 0.0f), static_cast<std::uint32_t>(i)};
    });
    tbb::parallel_sort(places, [](const Place& a, const Place& b) {
        return std::tie(a.x, a.y, a.z, a.vertex) < std::tie(b.x, b.y, b.z, b.vertex);
    });
    const auto apart = [](const Place& a, const Place& b) {
        return std::tie(a.x, a.y, a.z) != std::tie(b.x, b.y, b.z);
    };
    std::vector<std::uint32_t> number(places.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0 && apart(places[i], places[i - 1])) ++next;
        number[places[i].vertex] = next;
    }
    return number;
}

std::vector<Edge> edges_in_order(const Scene& scene) {
    const std::vector<std::uint32_t> number = vertices_by_position(scene);
    std::vector<Edge> edges(3 * scene.triangle.size());
    tbb::parallel_for(std::size_t{0}, scene.triangle.size(), [&](std::size_t t) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t from = number[scene.triangle[t][side]];
            const std::uint32_t to = number[scene.triangle[t][(side + 1) % 3]];
            edges[3 * t + side] = {std::uint64_t{std::min(from, to)} << 32 | std::max(from, to),
                                   static_cast<std::uint32_t>(t), from < to};
        }
    });
    tbb::parallel_sort(edges);
    return edges;
}

/// Calls `meet(a, b, cosine)` for the triangles on both sides of each edge. `cosine` is between the normals
/// of one face of the surface on both sides, whatever the winding of either triangle.
template <class Meet>
void for_each_meeting(const Scene& scene, std::span<const Edge> edges, Meet meet) {
    // If many triangles share an edge, each is compared only with those that follow it within this number.
    constexpr std::size_t most_at_an_edge = 8;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t end = std::min(edges.size(), i + most_at_an_edge);
        for (std::size_t k = i + 1; k < end && edges[k].ends == edges[i].ends; ++k) {
            const float cosine =
                scene.geometric_normal[edges[i].triangle].dot(scene.geometric_normal[edges[k].triangle]);
            meet(edges[i].triangle, edges[k].triangle, edges[i].upward == edges[k].upward ? -cosine : cosine);
        }
    }
}

}  // namespace

SurfacePieces::SurfacePieces(const Scene& scene) {
    const std::vector<Edge> edges = edges_in_order(scene);
    JoinedSets joined(scene.triangle.size());
    for_each_meeting(scene, edges, [&](std::uint32_t a, std::uint32_t b, float cosine) {
        if (cosine >= same_piece_cosine) joined.join(a, b);
    });
    piece_of_ = joined.numbers();
    const std::uint32_t pieces =
        piece_of_.empty() ? 0 : *std::max_element(piece_of_.begin(), piece_of_.end()) + 1;

    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for_each_meeting(scene, edges, [&](std::uint32_t a, std::uint32_t b, float cosine) {
        const std::uint32_t p = piece_of_[a], q = piece_of_[b];
        if (p == q || cosine <= -same_piece_cosine) return;
        pairs.emplace_back(p, q);
        pairs.emplace_back(q, p);
    });
    tbb::parallel_sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    first_touching_.assign(pieces + std::size_t{1}, 0);
    touching_.reserve(pairs.size());
    for (const auto& [piece, other] : pairs) {
        ++first_touching_[piece + 1];
        touching_.push_back(other);
    }
    std::partial_sum(first_touching_.begin(), first_touching_.end(), first_touching_.begin());
}

}  // namespace common
