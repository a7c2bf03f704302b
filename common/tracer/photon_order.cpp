#include "common/tracer/photon_order.h"

#include <algorithm>
#include <utility>

namespace common {
namespace {

/// Inserts two zero bits after each of the lowest three.
std::uint32_t spread(std::uint32_t bits) {
    return (bits & 1) | (bits & 2) << 2 | (bits & 4) << 4;
}

std::uint32_t cell_of(float at, float cells) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(std::max(at, 0.0f), cells - 1)));
}

}  // namespace

PhotonOrder::PhotonOrder(const Imath::Box3f& bounds) : low_(bounds.min) {
    const Vec3 size = bounds.size();
    for (int axis = 0; axis < 3; ++axis)
        cells_per_unit_[axis] = size[axis] > 0 ? static_cast<float>(1 << cell_bits) / size[axis] : 0;
}

void PhotonOrder::find_keys(const PhotonBatch& photons) {
    const std::size_t count = photons.size();
    key_.resize(count);
    const Vec3View<const float> origin = photons.origin.view(), direction = photons.direction.view();
    std::uint32_t* const key = key_.data();
    const Vec3 low = low_, scale = cells_per_unit_;
    constexpr float cells = 1 << cell_bits;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t cell = spread(cell_of((origin.x[i] - low.x) * scale.x, cells)) |
                                   spread(cell_of((origin.y[i] - low.y) * scale.y, cells)) << 1 |
                                   spread(cell_of((origin.z[i] - low.z) * scale.z, cells)) << 2;
        const std::uint32_t octant =
            (direction.x[i] < 0 ? 1u : 0u) | (direction.y[i] < 0 ? 2u : 0u) | (direction.z[i] < 0 ? 4u : 0u);
        key[i] = octant << (3 * cell_bits) | cell;
    }
}

std::span<const std::uint32_t> PhotonOrder::sort(const PhotonBatch& photons,
                                                 std::span<const std::uint32_t> alive) {
    find_keys(photons);
    // A counting sort. Dead photons are written to a slot of their own, to avoid mispredicted branches.
    next_.fill(0);
    for (std::size_t i = 0; i < alive.size(); ++i) next_[key_[i]] += alive[i];
    std::uint32_t begin = 0;
    for (std::uint32_t& next : next_) begin += std::exchange(next, begin);
    order_.resize(alive.size() + 1);
    for (std::size_t i = 0; i < alive.size(); ++i) {
        std::uint32_t& next = next_[key_[i]];
        order_[alive[i] ? next : alive.size()] = static_cast<std::uint32_t>(i);
        next += alive[i];
    }
    return std::span(order_).first(begin);
}

}  // namespace common
