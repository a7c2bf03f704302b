// Sorts photons so that neighbours travel alike, which makes packets of rays worthwhile.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/tracer/photon_batch.h"

namespace common {

/// Sorts by octant of the direction, and within each by the cell of the origin along a Morton curve through
/// the scene. Rays of one octant visit the nodes of a BVH in the same order.
class PhotonOrder {
  public:
    /// `bounds` is that of the scene; origins outside are clamped to its faces.
    explicit PhotonOrder(const Imath::Box3f& bounds);

    /// Returns the indices of the photons for which `alive` is not 0; photons with equal keys keep their
    /// order. Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> sort(const PhotonBatch& photons,
                                                      std::span<const std::uint32_t> alive);

  private:
    static constexpr unsigned cell_bits = 3;  ///< per axis
    static constexpr std::size_t keys = std::size_t{8} << (3 * cell_bits);

    void find_keys(const PhotonBatch& photons);

    Vec3 low_, cells_per_unit_;
    std::vector<std::uint32_t> key_;
    std::array<std::uint32_t, keys> next_;  ///< position of the next photon of each key
    std::vector<std::uint32_t> order_;
};

}  // namespace common
