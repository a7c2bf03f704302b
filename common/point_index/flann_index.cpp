#include "common/point_index/flann_index.h"

#include <flann/algorithms/kdtree_index.h>
#include <flann/algorithms/kdtree_single_index.h>
#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/core/memory_use.h"

namespace common {
namespace {

/// FLANN takes a matrix of mutable floats, but does not change it.
flann::Matrix<float> as_matrix(std::span<const Vec3> points) {
    return {const_cast<float*>(&points.front().x), points.size(), 3};
}

void check_count(std::size_t points) {
    if (points > max_flann_points)
        throw InputError(
            fmt::format("FLANN holds at most {} points; {} were asked for", max_flann_points, points));
}

}  // namespace

FlannIndex::FlannIndex(std::span<const Vec3> points) {
    check_count(points.size());
    if (points.empty()) return;
    constexpr int points_per_leaf = 16;
    const std::size_t before = heap_bytes();
    tree_ = std::make_unique<flann::KDTreeSingleIndex<FlannDistance>>(
        as_matrix(points), flann::KDTreeSingleIndexParams(points_per_leaf));
    tree_->buildIndex();
    bytes_ = heap_bytes() - before;
}

void FlannIncrementalIndex::add(std::span<const Vec3> points) {
    check_count(size_ + points.size());
    if (points.empty()) return;
    const std::size_t before = heap_bytes();
    if (tree_) {
        tree_->addPoints(as_matrix(points));
    } else {
        tree_ = std::make_unique<flann::KDTreeIndex<FlannDistance>>(as_matrix(points),
                                                                    flann::KDTreeIndexParams(1));
        tree_->buildIndex();
    }
    size_ += points.size();
    bytes_ += heap_bytes() - before;
}

}  // namespace common
