// How a photon map estimates irradiance from the photons around a point.
#pragma once

#include <cstddef>
#include <variant>

namespace photonmap {

/// The k nearest. More photons in the map shrink the radius and leave the noise as it is: 1 / sqrt(k - 2).
struct NearestPhotons {
    std::size_t count = 50;
    friend bool operator==(const NearestPhotons&, const NearestPhotons&) = default;
};

/// The k nearest with k = factor * N^(2/3) of the N photons stored, at least 2: noise and blur both vanish as
/// N grows, at the best rate that a density estimate has (Knaus and Zwicker 2011).
struct GrowingNumber {
    double factor;
    friend bool operator==(const GrowingNumber&, const GrowingNumber&) = default;
};

/// All photons within this fraction of the scene's diagonal.
struct FixedRadius {
    double diagonal_fraction;
    friend bool operator==(const FixedRadius&, const FixedRadius&) = default;
};

using PhotonSelection = std::variant<NearestPhotons, GrowingNumber, FixedRadius>;

/// How a photon's weight falls off with its distance.
enum class Kernel { disc, cone, epanechnikov };

struct GatherSettings {
    PhotonSelection selection = NearestPhotons{};
    Kernel kernel = Kernel::disc;
    /// World units, > 0: a sparse place uses the photons inside and looks no farther. Not for FixedRadius.
    float max_radius = 0;
};

/// No photon farther than this counts, world units.
[[nodiscard]] inline float largest_radius(const GatherSettings& settings, float scene_diagonal) {
    if (const auto* fixed = std::get_if<FixedRadius>(&settings.selection))
        return static_cast<float>(fixed->diagonal_fraction) * scene_diagonal;
    return settings.max_radius;
}

/// A max_radius for scenes about which nothing is known: 1/20 of the diagonal.
[[nodiscard]] inline float default_max_radius(float scene_diagonal) {
    return scene_diagonal / 20;
}

}  // namespace photonmap
