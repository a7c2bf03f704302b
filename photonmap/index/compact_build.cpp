#include "photonmap/index/compact_build.h"

namespace photonmap {
namespace {

std::size_t nodes_for(std::size_t children) {
    return (children + children_per_node - 1) / children_per_node;
}

/// Returns the number of nodes between the leaves and the root.
std::size_t inner_nodes(std::size_t leaves) {
    std::size_t inner = 0;
    for (std::size_t level = nodes_for(leaves); level > 1; level = nodes_for(level)) inner += level;
    return inner;
}

struct Box {
    float low[3], high[3];
};

/// Returns the box of the points in a leaf. NaN is never the smaller or the larger one.
Box box_of(const CompactLeaf& leaf) {
    const float* const lanes[3] = {leaf.x, leaf.y, leaf.z};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        float low = lanes[axis][0], high = low;
        for (std::size_t i = 1; i < points_per_leaf; ++i) {
            low = lanes[axis][i] < low ? lanes[axis][i] : low;
            high = lanes[axis][i] > high ? lanes[axis][i] : high;
        }
        box.low[axis] = low;
        box.high[axis] = high;
    }
    return box;
}

Box box_of(const CompactNode& node) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = *std::min_element(node.low[axis], node.low[axis] + node.children);
        box.high[axis] = *std::max_element(node.high[axis], node.high[axis] + node.children);
    }
    return box;
}

template <class Children>
CompactNode node_over(const Children& children, std::size_t first, std::size_t count, bool are_leaves) {
    CompactNode node{};
    node.first_child = static_cast<std::uint32_t>(first);
    node.children = static_cast<std::uint16_t>(count);
    node.has_leaves = are_leaves;
    for (std::size_t child = 0; child < count; ++child) {
        const Box box = box_of(children[first + child]);
        for (int axis = 0; axis < 3; ++axis) {
            node.low[axis][child] = box.low[axis];
            node.high[axis][child] = box.high[axis];
        }
    }
    return node;
}

/// Returns the nodes of every level above the cells, from the root; cells with equal leading bits share one.
std::vector<std::vector<std::uint32_t>> prefixes_above(std::span<const CompactShape::Cell> cells,
                                                       int levels) {
    std::vector<std::vector<std::uint32_t>> prefixes(static_cast<std::size_t>(levels));
    for (int level = 0; level < levels; ++level)
        for (const CompactShape::Cell& cell : cells) {
            auto& there = prefixes[static_cast<std::size_t>(level)];
            const std::uint32_t prefix = cell.number >> (4 * (levels - level));
            if (there.empty() || there.back() != prefix) there.push_back(prefix);
        }
    return prefixes;
}

}  // namespace

CompactShape::CompactShape(const CellGrid& grid, std::span<const std::size_t> begin) {
    for (std::uint32_t c = 0; c < grid.cells(); ++c)
        if (begin[c + 1] > begin[c]) cells.push_back({c, begin[c], begin[c + 1] - begin[c], 0, 0, 0});
    for (const auto& level : prefixes_above(cells, grid.levels())) nodes_above_cells += level.size();
    nodes = nodes_above_cells;
    for (Cell& cell : cells) cell.root = static_cast<std::uint32_t>(nodes++);
    for (Cell& cell : cells) {
        const std::size_t cell_leaves = (cell.points + points_per_leaf - 1) / points_per_leaf;
        cell.first_leaf = static_cast<std::uint32_t>(leaves);
        cell.first_inner = static_cast<std::uint32_t>(nodes);
        leaves += cell_leaves;
        nodes += inner_nodes(cell_leaves);
    }
}

void fill(CompactLeaf& leaf, std::span<const Member> points) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t lane = 0; lane < points_per_leaf; ++lane) {
        const std::array<float, 3> position =
            lane < points.size() ? points[lane].position : std::array{nan, nan, nan};
        leaf.x[lane] = position[0];
        leaf.y[lane] = position[1];
        leaf.z[lane] = position[2];
    }
}

void add_cell_nodes(const CompactShape::Cell& cell, CompactTree& tree) {
    const std::span<CompactNode> nodes = tree.nodes.elements();
    const std::span<const CompactLeaf> leaves = tree.leaves.span();
    std::size_t children = (cell.points + points_per_leaf - 1) / points_per_leaf;
    std::size_t first_child = cell.first_leaf, next = cell.first_inner;
    for (bool are_leaves = true;; are_leaves = false) {
        const std::size_t level = nodes_for(children), first = level == 1 ? cell.root : next;
        for (std::size_t n = 0; n < level; ++n) {
            const std::size_t begin = first_child + n * children_per_node;
            const std::size_t count = std::min(children_per_node, children - n * children_per_node);
            nodes[first + n] =
                are_leaves ? node_over(leaves, begin, count, true) : node_over(nodes, begin, count, false);
        }
        if (level == 1) return;
        first_child = first;
        next += level;
        children = level;
    }
}

void add_nodes_above_cells(const CompactShape& shape, const CellGrid& grid, CompactTree& tree) {
    const std::span<CompactNode> nodes = tree.nodes.elements();
    auto prefixes = prefixes_above(shape.cells, grid.levels());
    std::vector<std::uint32_t> below;
    for (const CompactShape::Cell& cell : shape.cells) below.push_back(cell.number);
    std::size_t first_below = shape.nodes_above_cells;
    for (; !prefixes.empty(); prefixes.pop_back()) {
        const std::vector<std::uint32_t>& level = prefixes.back();
        const std::size_t first = first_below - level.size();
        std::size_t child = 0;
        for (std::size_t n = 0; n < level.size(); ++n) {
            const std::size_t begin = child;
            while (child < below.size() && below[child] >> 4 == level[n]) ++child;
            nodes[first + n] = node_over(nodes, first_below + begin, child - begin, false);
        }
        below = level;
        first_below = first;
    }
}

}  // namespace photonmap
