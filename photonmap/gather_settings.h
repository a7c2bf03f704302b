// How a photon map estimates irradiance from its nearest photons.
#pragma once

#include <cstddef>

namespace photonmap {

struct GatherSettings {
    std::size_t nearest = 50;  ///< photons per estimate, k; the k-th gives the radius
    float max_radius = 0;      ///< world units, > 0; a sparse place uses what lies inside
    float cone_slope = 0;      ///< of Jensen's cone filter, >= 1; 0: every photon counts the same
};

/// A max_radius for scenes about which nothing is known: 1/20 of the diagonal.
[[nodiscard]] inline float default_max_radius(float scene_diagonal) {
    return scene_diagonal / 20;
}

}  // namespace photonmap
