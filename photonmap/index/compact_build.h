// Builds the compact index: cells, leaves, boxes.
#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "photonmap/index/cell_grid.h"
#include "photonmap/index/compact_index.h"
#include "photonmap/index/leaf_order.h"

namespace photonmap {

/// The places of each cell's leaves and nodes, computed from the cells' numbers of points alone.
struct CompactShape {
    struct Cell {
        std::uint32_t number;                         ///< number in the grid
        std::size_t first_point, points;              ///< in the sorted records
        std::uint32_t first_leaf, root, first_inner;  ///< in the tree; inner nodes from the leaves up
    };
    std::vector<Cell> cells;  ///< only those that have points
    std::size_t nodes_above_cells = 0, leaves = 0, nodes = 0;

    CompactShape(const CellGrid& grid, std::span<const std::size_t> begin);
};

/// Fills a leaf; lanes without a point become NaN.
void fill(CompactLeaf& leaf, std::span<const Member> points);

/// Adds the nodes of a cell whose leaves are filled.
void add_cell_nodes(const CompactShape::Cell& cell, CompactTree& tree);

/// Adds the nodes above the cells, whose own nodes must be done.
void add_nodes_above_cells(const CompactShape& shape, const CellGrid& grid, CompactTree& tree);

/// Builds an index over the `position` of records. First calls `reserve(places)` with the number of places in
/// the index. Then calls `place(index, record)` once for each record, on any thread, to store its other data
/// at its place. There are slightly more places than records, as each cell ends with a leaf of its own.
///
/// Takes little more memory than the records or the finished index, whichever is more, as what has been read
/// is released. Uses the threads of the calling arena; the result does not depend on them.
///
/// Points are sorted into a coarse grid, and in each cell into a kd-tree that is split at medians along the
/// widest axis. Measured with 1e7 photons of cornell.glb and leaves of 16, a search for 50 visits 12 leaves
/// and 9 nodes in this order (8 and 8 with the leaves of 32 that are used). It visits 21 and 15 along a
/// Hilbert curve, 42 and 29 along a Morton curve.
template <class Record, class Reserve, class Place>
[[nodiscard]] CompactIndex build_compact_index(common::StableArray<Record>&& records, Reserve reserve,
                                               Place place) {
    CellSorted<Record> sorted = sort_into_cells(std::move(records));
    const CompactShape shape(sorted.grid, sorted.begin);
    CompactTree tree{common::StableArray<CompactLeaf>(shape.leaves),
                     common::StableArray<CompactNode>(shape.nodes)};
    const std::span<CompactLeaf> leaves = tree.leaves.grow(shape.leaves);
    tree.nodes.grow(shape.nodes);
    reserve(shape.leaves * points_per_leaf);

    tbb::enumerable_thread_specific<LeafCutter> cutters;
    tbb::parallel_for(std::size_t{0}, shape.cells.size(), [&](std::size_t c) {
        const CompactShape::Cell& cell = shape.cells[c];
        for_each_run(sorted.records.elements().subspan(cell.first_point, cell.points), 0,
                     [&](std::span<const Record> run, std::size_t first) {
                         LeafCutter& cutter = cutters.local();
                         const std::span<Member> members = cutter.members(run.size());
                         for (std::uint32_t i = 0; i < run.size(); ++i) {
                             const common::Vec3& at = run[i].position;
                             members[i] = {{at.x, at.y, at.z}, i};
                         }
                         std::size_t leaf = cell.first_leaf + first / points_per_leaf;
                         cutter.for_each_leaf([&](std::span<const Member> points) {
                             fill(leaves[leaf], points);
                             for (std::size_t lane = 0; lane < points.size(); ++lane)
                                 place(leaf * points_per_leaf + lane, run[points[lane].number]);
                             ++leaf;
                         });
                     });
        add_cell_nodes(cell, tree);
        sorted.records.release(cell.first_point, cell.first_point + cell.points, sorted.page_bytes);
    });
    add_nodes_above_cells(shape, sorted.grid, tree);
    return CompactIndex(std::move(tree), sorted.records.size());
}

}  // namespace photonmap
