// Photons at addresses that do not change.
#pragma once

#include <span>

#include "common/core/stable_array.h"
#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/rejected_hits.h"
#include "photonmap/photon.h"

namespace photonmap {

/// Append-only columns of positions and photons.
class PhotonStorage {
  public:
    /// The number of photons that one index can count.
    static constexpr std::size_t max_photons = 0xffffffff;

    PhotonStorage() : PhotonStorage(max_photons) {}

    /// Appends the finite hits of a wave in order, with all threads of the calling arena. Throws
    /// std::bad_alloc past max_photons.
    void append(std::span<const common::HitBatch> wave);

    /// Returns the same photons in the order of photonmap::morton_order.
    [[nodiscard]] PhotonStorage sorted_along_curve() &&;

    /// Returns the same photons in the order of `order`, which has each index once.
    [[nodiscard]] PhotonStorage in_order(std::span<const std::uint32_t> order) &&;

    /// Returns a predicate that tells whether a photon's surface faces as `normal` does.
    [[nodiscard]] auto same_surface(const common::Scene& scene, const common::Vec3& normal) const {
        return [this, &scene, normal](std::uint32_t i) {
            return arrival_normal(photons_[i], scene.geometric_normal).dot(normal) >
                   common::same_surface_cosine;
        };
    }

    /// Returns a photon's flux for the shading normal, W times the number emitted.
    [[nodiscard]] common::Rgb tilted_flux(const common::Scene& scene, std::uint32_t i,
                                          const common::Vec3& shading_normal) const {
        return photonmap::tilted_flux(photons_[i], scene.geometric_normal, shading_normal);
    }

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
