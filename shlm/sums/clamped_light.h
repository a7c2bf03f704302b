// The light that is lost by clamping the cosine.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/estimator/irradiance_estimator.h"
#include "shlm/sums/quantum.h"

namespace shlm {

/// Sums over all stored hits, mean of the channels, as integers for the same reason as in TexelSums.
struct ClampedLight {
    std::uint64_t flux = 0;  ///< in units of Quantum::clamped_light_unit
    std::uint64_t discarded =
        0;  ///< the part of it that is missing in the surface's irradiance: F (1 - cos theta / clamp)

    /// Adds a hit's flux, in that unit, with its cosine of incidence.
    void add(float mean_flux, float incident_cosine) {
        flux += static_cast<std::uint64_t>(std::llrint(mean_flux));
        if (incident_cosine < common::min_incident_cosine)
            discarded += static_cast<std::uint64_t>(
                std::llrint(mean_flux * (1 - incident_cosine / common::min_incident_cosine)));
    }

    [[nodiscard]] double discarded_share() const {
        return flux > 0 ? static_cast<double>(discarded) / static_cast<double>(flux) : 0;
    }

    ClampedLight& operator+=(const ClampedLight& other) {
        flux += other.flux;
        discarded += other.discarded;
        return *this;
    }

    friend bool operator==(const ClampedLight&, const ClampedLight&) = default;
};

}  // namespace shlm
