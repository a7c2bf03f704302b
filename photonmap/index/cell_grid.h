// Sorts points into the cells of a coarse grid, within the memory that they take already.
#pragma once

#include <Imath/ImathBox.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/core/stable_array.h"
#include "common/core/vector.h"

namespace photonmap {

/// Cubic cells over the points' bounding box in Morton order. A cell's number has four bits per level, so
/// that the cells of one parent have consecutive numbers.
class CellGrid {
  public:
    static constexpr int max_levels = 3;

    CellGrid(const Imath::Box3f& bounds, std::size_t points);

    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] std::size_t cells() const { return std::size_t{1} << (4 * levels_); }

    [[nodiscard]] std::uint32_t cell_of(const common::Vec3& point) const {
        // Inserts two zeros between the four bits.
        const auto spread = [](float at) {
            auto bits = static_cast<std::uint32_t>(static_cast<int>(std::min(15.0f, std::max(0.0f, at))));
            bits = (bits | bits << 4) & 0xc3;
            return (bits | bits << 2) & 0x249;
        };
        const common::Vec3 at = (point - low_) * cells_per_unit_;
        return (spread(at.x) << 2 | spread(at.y) << 1 | spread(at.z)) >> (4 * (max_levels - levels_));
    }

  private:
    common::Vec3 low_;
    float cells_per_unit_;
    int levels_;
};

/// Records with a `position`, sorted by cell; those of a cell keep their order.
template <class Record>
struct CellSorted {
    CellGrid grid;
    common::StableArray<Record> records;
    std::vector<std::size_t> begin;  ///< first record of each cell, and the end

    /// When a cell is done, its memory can be released in whole blocks of this size.
    static constexpr std::size_t page_bytes = 4096;
};

template <class Record>
Imath::Box3f bounds_of(std::span<const Record> records) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, records.size(), 1 << 16), Imath::Box3f(),
        [&](const tbb::blocked_range<std::size_t>& range, Imath::Box3f box) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) box.extendBy(records[i].position);
            return box;
        },
        [](Imath::Box3f a, const Imath::Box3f& b) {
            a.extendBy(b);
            return a;
        });
}

/// A counting sort, not in place. The new array is filled while the old one is read from front to back, and
/// what has been read is released. So both together hardly take more than one of them plus two bytes per
/// record.
template <class Record>
CellSorted<Record> sort_into_cells(common::StableArray<Record>&& unsorted) {
    constexpr std::size_t block = 1 << 15;  // records that one task counts and moves
    constexpr std::size_t blocks_per_chunk = 32;
    constexpr std::size_t large_page = 2 << 20;

    common::StableArray<Record> from = std::move(unsorted);
    const std::size_t count = from.size(), blocks = (count + block - 1) / block;
    const CellGrid grid(bounds_of(from.span()), count);
    const std::size_t cells = grid.cells();
    const auto end_of = [&](std::size_t b) { return std::min(count, (b + 1) * block); };

    common::StableArray<std::uint16_t> cell_of(count);
    const std::span<std::uint16_t> cell = cell_of.grow(count);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
        for (std::size_t i = b * block; i < end_of(b); ++i)
            cell[i] = static_cast<std::uint16_t>(grid.cell_of(from[i].position));
    });

    // Counts per cell, separately for each block, are added up in a fixed order.
    std::vector<std::uint32_t> counts(blocks_per_chunk * cells);
    const auto count_chunk = [&](std::size_t chunk, std::size_t in_chunk, auto add) {
        tbb::parallel_for(std::size_t{0}, in_chunk, [&](std::size_t b) {
            std::uint32_t* const counted = &counts[b * cells];
            std::fill_n(counted, cells, 0u);
            for (std::size_t i = (chunk + b) * block; i < end_of(chunk + b); ++i) ++counted[cell[i]];
        });
        for (std::size_t b = 0; b < in_chunk; ++b)
            for (std::size_t c = 0; c < cells; ++c) add(b, c, counts[b * cells + c]);
    };
    std::vector<std::size_t> begin(cells + 1, 0);
    for (std::size_t chunk = 0; chunk < blocks; chunk += blocks_per_chunk)
        count_chunk(chunk, std::min(blocks_per_chunk, blocks - chunk),
                    [&](std::size_t, std::size_t c, std::uint32_t counted) { begin[c + 1] += counted; });
    for (std::size_t c = 0; c < cells; ++c) begin[c + 1] += begin[c];

    CellSorted<Record> sorted{
        grid, common::StableArray<Record>(count, common::StableArray<Record>::Pages::small), begin};
    const std::span<Record> to = sorted.records.grow(count);
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    std::vector<std::size_t> first(blocks_per_chunk * cells);
    for (std::size_t chunk = 0; chunk < blocks; chunk += blocks_per_chunk) {
        const std::size_t in_chunk = std::min(blocks_per_chunk, blocks - chunk);
        count_chunk(chunk, in_chunk, [&](std::size_t b, std::size_t c, std::uint32_t counted) {
            first[b * cells + c] = next[c];
            next[c] += counted;
        });
        tbb::parallel_for(std::size_t{0}, in_chunk, [&](std::size_t b) {
            std::size_t* const at = &first[b * cells];
            for (std::size_t i = (chunk + b) * block; i < end_of(chunk + b); ++i) to[at[cell[i]]++] = from[i];
        });
        from.release(0, end_of(chunk + in_chunk - 1), large_page);
    }
    return sorted;
}

}  // namespace photonmap
