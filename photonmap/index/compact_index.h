// Our own point index: exact, small, and fast to build and to query.
#pragma once

#include <array>
#include <bit>
#include <limits>

#include "common/core/prefetch.h"
#include "common/core/vector.h"
#include "common/point_index/point_index.h"
#include "photonmap/index/compact_tree.h"

namespace photonmap {

/// A BVH with 16 children per node and leaves of 32 points, which it owns. build_compact_index() makes it and
/// gives the points new indices: places in the leaves, of which some stay empty.
class CompactIndex {
  public:
    /// The places that 32 bits can index, less those that the grid's cells may leave empty.
    static constexpr std::size_t max_points = 0xffffffff - 4096 * points_per_leaf;

    CompactIndex(CompactTree tree, std::size_t points) : tree_(std::move(tree)), size_(points) {}

    template <common::PointCollector Collector, class Accept>
    void search(const common::Vec3& query, Collector& collector, Accept accept) const {
        if (size_ == 0) return;
        std::array<Ahead, most_ahead> stack;  // the nearest on top
        std::size_t ahead = 0;
        stack[ahead++] = {0, 0};
        while (ahead > 0) {
            const Ahead next = stack[--ahead];
            if (!(next.distance_sq <= collector.reach_sq())) continue;
            if (next.where & is_leaf)
                offer_leaf(next.where & ~is_leaf, query, collector, accept);
            else
                ahead = push_children(tree_.nodes[next.where], query, collector.reach_sq(), stack, ahead);
        }
    }

    [[nodiscard]] common::Vec3 position(std::size_t index) const {
        const CompactLeaf& leaf = tree_.leaves[index / points_per_leaf];
        const std::size_t lane = index % points_per_leaf;
        return {leaf.x[lane], leaf.y[lane], leaf.z[lane]};
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t bytes() const { return tree_.leaves.bytes() + tree_.nodes.bytes(); }
    [[nodiscard]] const CompactTree& tree() const { return tree_; }

  private:
    /// A node still to be visited, or a leaf if the highest bit is set.
    struct Ahead {
        float distance_sq;  ///< to its box; also after rounding, no more than that to any point in the box
        std::uint32_t where;
    };
    static constexpr std::uint32_t is_leaf = 0x80000000;
    /// Three levels of cells and seven below hold 2^32 points. Each leaves 15 siblings of the node visited
    /// next.
    static constexpr std::size_t most_ahead = 10 * (children_per_node - 1) + children_per_node;

    template <class Collector, class Accept>
    void offer_leaf(std::uint32_t number, const common::Vec3& query, Collector& collector,
                    Accept& accept) const {
        const CompactLeaf& leaf = tree_.leaves[number];
        std::array<float, points_per_leaf> distance_sq;
        for (std::size_t i = 0; i < points_per_leaf; ++i) {
            const float x = query.x - leaf.x[i], y = query.y - leaf.y[i], z = query.z - leaf.z[i];
            distance_sq[i] = x * x + y * y + z * z;
        }
        const auto first = static_cast<std::uint32_t>(number * points_per_leaf);
        for (std::uint32_t left = within(distance_sq, collector.reach_sq()); left != 0; left &= left - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
            if (accept(first + lane)) collector.offer(distance_sq[lane], first + lane);
        }
    }

    /// Pushes the children within reach, the farthest first. Returns the new size of the stack.
    std::size_t push_children(const CompactNode& node, const common::Vec3& query, float reach_sq,
                              std::array<Ahead, most_ahead>& stack, std::size_t ahead) const {
        std::array<float, children_per_node> distance_sq;
        const auto outside = [&](int axis, std::size_t i) {
            return std::max(std::max(node.low[axis][i] - query[axis], query[axis] - node.high[axis][i]),
                            0.0f);
        };
        for (std::size_t i = 0; i < children_per_node; ++i) {
            const float x = outside(0, i), y = outside(1, i), z = outside(2, i);
            distance_sq[i] = x * x + y * y + z * z;
        }
        const std::uint32_t there = (1u << node.children) - 1, kind = node.has_leaves ? is_leaf : 0;
        const std::size_t base = ahead;
        for (std::uint32_t left = within(distance_sq, reach_sq) & there; left != 0; left &= left - 1) {
            const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
            const Ahead child{distance_sq[i], (node.first_child + i) | kind};
            prefetch(child.where);
            std::size_t at = ahead++;
            for (; at > base && stack[at - 1].distance_sq < child.distance_sq; --at)
                stack[at] = stack[at - 1];
            stack[at] = child;
        }
        return ahead;
    }

    /// Returns one bit for each distance.
    template <std::size_t N>
    static std::uint32_t within(const std::array<float, N>& distance_sq, float reach_sq) {
        std::uint32_t bits = 0;
        for (std::uint32_t i = 0; i < N; ++i) bits |= std::uint32_t{distance_sq[i] <= reach_sq} << i;
        return bits;
    }

    /// A search in a large map mostly waits for memory.
    void prefetch(std::uint32_t where) const {
        if (where & is_leaf)
            common::prefetch<common::PrefetchFor::reading>(tree_.leaves[where & ~is_leaf]);
        else
            common::prefetch<common::PrefetchFor::reading>(tree_.nodes[where]);
    }

    CompactTree tree_;
    std::size_t size_;
};

static_assert(common::PointIndex<CompactIndex>);

}  // namespace photonmap
