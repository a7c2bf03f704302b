// Splits the points of a cell into the leaves of a kd-tree.
#pragma once

#include <Imath/ImathBox.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "common/core/vector.h"
#include "photonmap/index/compact_tree.h"

namespace photonmap {

/// Returns the size of the left part when a run of more than one leaf is split: the largest power of two of
/// whole leaves. So all subtrees that become one node begin at a multiple of their size.
[[nodiscard]] inline std::size_t left_part(std::size_t points) {
    return std::bit_floor((points - 1) / points_per_leaf) * points_per_leaf;
}

/// A point on its way into a leaf, and its number in the cell.
struct alignas(16) Member {
    std::array<float, 3> position;
    std::uint32_t number;
};

/// Splits a cell into leaves. Each split is along the widest axis of the box, at the number of points that
/// left_part() returns. Keeps its memory from cell to cell; use one per thread.
class LeafCutter {
  public:
    /// Larger cells are first split as records: this many members stay in a core's own cache.
    static constexpr std::size_t most_members = 1 << 16;

    /// Returns room for the members of the next cell, at most most_members, to be filled in.
    [[nodiscard]] std::span<Member> members(std::size_t count) {
        members_.resize(count);
        scratch_.resize(count);
        return members_;
    }

    /// Calls `use(members)` for each leaf in turn.
    template <class Use>
    void for_each_leaf(Use use) {
        cut(std::span(members_), std::span(scratch_), use);
    }

  private:
    template <class Use>
    static void cut(std::span<Member> members, std::span<Member> scratch, Use& use) {
        if (members.size() <= points_per_leaf) return use(std::span<const Member>(members));
        const std::size_t left = left_part(members.size());
        if (members.size() <= most_ranked)
            sort(members, scratch);
        else
            select(members, scratch, left);
        // Both parts are in the scratch now.
        cut(scratch.first(left), members.first(left), use);
        cut(scratch.subspan(left), members.subspan(left), use);
    }

    static constexpr std::size_t most_ranked = 256;

    /// Sorts the members into `out`, by counting how many are before each.
    static void sort(std::span<const Member> members, std::span<Member> out);
    /// Puts the first `left` members before the others in `out`, by a histogram.
    static void select(std::span<const Member> members, std::span<Member> out, std::size_t left);

    std::vector<Member> members_, scratch_;
};

/// Calls `use(records, first)` with consecutive runs of at most LeafCutter::most_members records, split as
/// LeafCutter splits them. `first` is the number of a run's first record, counted from the given one. May use
/// several threads at once.
template <class Record, class Use>
void for_each_run(std::span<Record> records, std::size_t first, const Use& use) {
    if (records.size() <= LeafCutter::most_members) return use(records, first);
    Imath::Box3f box;
    for (const Record& record : records) box.extendBy(record.position);
    const auto axis = static_cast<int>(box.majorAxis());
    const std::size_t left = left_part(records.size());
    std::nth_element(
        records.begin(), records.begin() + static_cast<std::ptrdiff_t>(left), records.end(),
        [axis](const Record& a, const Record& b) { return a.position[axis] < b.position[axis]; });
    tbb::parallel_invoke([&] { for_each_run(records.first(left), first, use); },
                         [&] { for_each_run(records.subspan(left), first + left, use); });
}

}  // namespace photonmap
