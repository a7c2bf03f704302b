// How a photon map estimates irradiance from the photons around a point.
#pragma once

#include <cstddef>
#include <variant>

namespace photonmap {

/// The k nearest photons. More photons in the map shrink the radius; the noise stays at 1 / sqrt(k - 2).
struct NearestPhotons {
    std::size_t count = 50;
    friend bool operator==(const NearestPhotons&, const NearestPhotons&) = default;
};

/// The k nearest photons with k = factor * N^(2/3) of the N photons stored, at least 2. Variance and bias
/// both vanish as N grows, at the best rate of a density estimate (Knaus and Zwicker 2011).
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
    /// Largest radius, world units, > 0: a gather at a sparse place uses only the photons inside. Not for
    /// FixedRadius.
    float max_radius = 0;
};

/// Returns the radius beyond which no photon counts, world units.
[[nodiscard]] inline float largest_radius(const GatherSettings& settings, float scene_diagonal) {
    if (const auto* fixed = std::get_if<FixedRadius>(&settings.selection))
        return static_cast<float>(fixed->diagonal_fraction) * scene_diagonal;
    return settings.max_radius;
}

/// Returns a max_radius for scenes about which nothing is known: 1/20 of the diagonal.
[[nodiscard]] inline float default_max_radius(float scene_diagonal) {
    return scene_diagonal / 20;
}

}  // namespace photonmap
