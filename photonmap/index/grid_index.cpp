#include "photonmap/index/grid_index.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <stdexcept>

#include "common/core/input_error.h"

namespace photonmap {
namespace {

/// Calls `use(cell, index)` for every point, in ascending order within a cell. Each thread takes the points
/// of its own range of cells. So none waits for another, and the order does not depend on the number of
/// threads.
template <class Use>
void for_each_in_its_cell(const GridCells& cells, std::span<const common::Vec3> points, Use use) {
    const std::size_t parts = std::min<std::size_t>(tbb::this_task_arena::max_concurrency(), cells.count());
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        const std::size_t begin = cells.count() * part / parts, end = cells.count() * (part + 1) / parts;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const std::size_t cell = cells.of(points[i]); cell >= begin && cell < end) use(cell, i);
    });
}

void check_count(std::size_t points) {
    if (points > GridIndex::max_points)
        throw common::InputError(fmt::format("the grid holds at most {} points; {} were asked for",
                                             GridIndex::max_points, points));
}

}  // namespace

GridCells::GridCells(std::span<const common::Vec3> points, float radius) {
    check_count(points.size());
    if (points.empty()) return;
    Imath::Box3f bounds;
    for (const common::Vec3& point : points) bounds.extendBy(point);
    double extent[3], widest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        minimum_[axis] = bounds.min[axis];
        extent[axis] = double{bounds.max[axis]} - minimum_[axis];
        widest = std::max(widest, extent[axis]);
    }
    if (widest == 0) return;

    const double most_cells = 2 * static_cast<double>(points.size());
    double side = std::clamp(double{radius}, widest / most_cells, 2 * widest);
    const auto cells_of_side = [&] {
        double cells = 1;
        for (const double e : extent) cells *= std::floor(e / side) + 1;
        return cells;
    };
    while (cells_of_side() > most_cells) side *= 1.02;
    cells_per_unit_ = 1 / side;
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<std::size_t>(extent[axis] / side) + 1;
}

std::vector<std::uint32_t> GridCells::order(std::span<const common::Vec3> points) const {
    std::vector<std::uint32_t> next(count() + 1, 0);  // where the cell's next point goes
    for_each_in_its_cell(*this, points, [&](std::size_t cell, std::size_t) { ++next[cell + 1]; });
    for (std::size_t cell = 0; cell < count(); ++cell) next[cell + 1] += next[cell];
    std::vector<std::uint32_t> order(points.size());
    for_each_in_its_cell(*this, points, [&](std::size_t cell, std::size_t i) {
        order[next[cell]++] = static_cast<std::uint32_t>(i);
    });
    return order;
}

GridIndex::GridIndex(std::span<const common::Vec3> points, const GridCells& cells)
    : points_(points), cells_(cells) {
    check_count(points.size());
    begins_.resize(cells.count() + 1);
    std::size_t begun = 0;  // cells whose begin is known already
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t cell = cells.of(points[i]);
        if (cell + 1 < begun)
            throw std::logic_error("GridIndex: the points are not in the order of the cells");
        while (begun <= cell) begins_[begun++] = static_cast<std::uint32_t>(i);
    }
    std::fill(begins_.begin() + static_cast<std::ptrdiff_t>(begun), begins_.end(),
              static_cast<std::uint32_t>(points.size()));
}

}  // namespace photonmap
