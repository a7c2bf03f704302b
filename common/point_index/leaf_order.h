// The points of a cell in the order of a kd-tree's leaves.
#pragma once

#include <Imath/ImathBox.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <span>

#include "common/core/vector.h"
#include "common/point_index/compact_tree.h"

namespace common {

/// Where a run of more than one leaf is cut: the left part has the largest power of two of whole leaves.
/// All subtrees that become one node of the tree then begin at a multiple of their size.
[[nodiscard]] inline std::size_t left_part(std::size_t points) {
    return std::bit_floor((points - 1) / points_per_leaf) * points_per_leaf;
}

/// Reorders the records, which have a `position`, so that each leaf's worth of them and all that are cut
/// from it further up lie apart along some axis: the widest of the box of those that are cut there. Records
/// with equal coordinates may come to lie on either side of a cut, which boxes do not mind.
template <class Record>
void order_by_leaves(std::span<Record> records) {
    if (records.size() <= points_per_leaf) return;
    Imath::Box3f box;
    for (const Record& record : records) box.extendBy(record.position);
    const auto axis = static_cast<int>(box.majorAxis());
    const std::size_t left = left_part(records.size());
    std::nth_element(
        records.begin(), records.begin() + static_cast<std::ptrdiff_t>(left), records.end(),
        [axis](const Record& a, const Record& b) { return a.position[axis] < b.position[axis]; });
    constexpr std::size_t worth_a_task = 1 << 15;
    const auto order_left = [&] { order_by_leaves(records.first(left)); };
    const auto order_right = [&] { order_by_leaves(records.subspan(left)); };
    if (records.size() >= worth_a_task) {
        tbb::parallel_invoke(order_left, order_right);
    } else {
        order_left();
        order_right();
    }
}

}  // namespace common
