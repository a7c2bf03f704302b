// The photons themselves, at addresses that stay.
#pragma once

#include <span>

#include "common/core/stable_array.h"
#include "common/estimator/irradiance_estimator.h"
#include "photonmap/photon.h"

namespace photonmap {

/// Append-only columns of positions and photons.
class PhotonStorage {
  public:
    /// Room for what one index can count.
    static constexpr std::size_t max_photons = 0x7fffffff;

    PhotonStorage() : PhotonStorage(max_photons) {}

    /// Appends the finite hits of a wave in order, with all threads of the calling arena. Throws
    /// std::bad_alloc past max_photons.
    void append(std::span<const common::HitBatch> wave);

    /// The same photons in the order of common::morton_order.
    [[nodiscard]] PhotonStorage sorted_along_curve() &&;

    [[nodiscard]] const Photon& operator[](std::size_t i) const { return photons_[i]; }
    [[nodiscard]] std::span<const common::Vec3> positions() const { return positions_.span(); }
    [[nodiscard]] std::size_t size() const { return photons_.size(); }
    [[nodiscard]] std::size_t bytes() const { return positions_.bytes() + photons_.bytes(); }
    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }

  private:
    explicit PhotonStorage(std::size_t max_size) : positions_(max_size), photons_(max_size) {}

    common::StableArray<common::Vec3> positions_;
    common::StableArray<Photon> photons_;
    common::RejectedHits rejected_;
};

}  // namespace photonmap
