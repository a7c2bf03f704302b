// Photons sorted so that neighbours travel alike: what makes packets of rays worth tracing together.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/tracer/photon_batch.h"

namespace common {

/// By octant of the direction, and within each by the cell of the origin along a Morton curve through the
/// scene: rays of one octant visit the nodes of a bounding volume hierarchy in the same order.
class PhotonOrder {
  public:
    /// `bounds`: of the scene; origins outside count as on its faces.
    explicit PhotonOrder(const Imath::Box3f& bounds);

    /// The indices of those photons for which `alive` is not 0; equal ones keep their order. Valid until the
    /// next call.
    [[nodiscard]] std::span<const std::uint32_t> sort(const PhotonBatch& photons,
                                                      std::span<const std::uint32_t> alive);

  private:
    static constexpr unsigned cell_bits = 3;  ///< an axis
    static constexpr std::size_t keys = std::size_t{8} << (3 * cell_bits);

    void find_keys(const PhotonBatch& photons);

    Vec3 low_, cells_per_unit_;
    std::vector<std::uint32_t> key_;
    std::array<std::uint32_t, keys> next_;  ///< where the next photon of each key goes
    std::vector<std::uint32_t> order_;
};

}  // namespace common
