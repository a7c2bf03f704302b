#include "photonmap/index/nanoflann_index.h"

#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include "common/core/input_error.h"
#include "common/core/memory_use.h"

namespace photonmap {
namespace {

nanoflann::KDTreeSingleIndexAdaptorParams parameters() {
    constexpr std::size_t points_per_leaf = 32;  // fastest of 8 to 32, to build and for 50 nearest of 5e6
#if NANOFLANN_VERSION < 0x150
    return {points_per_leaf};
#else
    return {points_per_leaf, nanoflann::KDTreeSingleIndexAdaptorFlags::None,
            static_cast<unsigned>(tbb::this_task_arena::max_concurrency())};
#endif
}

}  // namespace

NanoflannIndex::Tree::Tree(std::span<const common::Vec3> p) : points{p}, index(3, points, parameters()) {}

NanoflannIndex::NanoflannIndex(std::span<const common::Vec3> points) {
    if (points.size() > max_points)
        throw common::InputError(fmt::format("nanoflann holds at most {} points here; {} were asked for",
                                             max_points, points.size()));
    if (points.empty()) return;
    const std::size_t before = common::heap_bytes();
    tree_ = std::make_unique<const Tree>(points);
    bytes_ = common::heap_bytes() - before;
}

}  // namespace photonmap
