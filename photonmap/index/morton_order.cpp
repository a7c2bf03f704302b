#include "photonmap/index/morton_order.h"

#include <Imath/ImathBox.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

namespace photonmap {
namespace {

struct CellOfPoint {
    std::uint64_t cell;
    std::uint32_t index;

    friend auto operator<=>(const CellOfPoint&, const CellOfPoint&) = default;
};

/// Inserts two zero bits after each of the lowest 21.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace

std::vector<std::uint32_t> morton_order(std::span<const common::Vec3> points) {
    Imath::Box3f bounds;
    for (const common::Vec3& point : points) bounds.extendBy(point);
    const common::Vec3 size = bounds.size();
    const float widest = std::max({size.x, size.y, size.z, 1e-30f});
    constexpr float cells = 2097151;  // 2^21 - 1

    std::vector<CellOfPoint> sorted(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const common::Vec3 at = (points[i] - bounds.min) * (cells / widest);
        sorted[i] = {spread(static_cast<std::uint64_t>(at.x)) |
                         spread(static_cast<std::uint64_t>(at.y)) << 1 |
                         spread(static_cast<std::uint64_t>(at.z)) << 2,
                     static_cast<std::uint32_t>(i)};
    });
    tbb::parallel_sort(sorted.begin(), sorted.end());

    std::vector<std::uint32_t> order(points.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) { order[i] = sorted[i].index; });
    return order;
}

}  // namespace photonmap
