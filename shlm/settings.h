// How a light map is laid out, filled and asked.
#pragma once

#include <cstddef>

namespace shlm {

/// What directional light a hit of flux F, on texel area a, at incidence theta stands for. The paper leaves
/// it open.
enum class ShWeight {
    radiance,  ///< F / (a cos theta): its irradiance on the surface is F / a, as it must be
    flux       ///< F / a: the paper read literally; reads two thirds of a uniform hemisphere
};

struct Settings {
    std::size_t texels = 262144;  ///< in all, as nearly as the layout allows
    ShWeight weight = ShWeight::radiance;
    std::size_t nearest = 4;  ///< texels per gather
};

}  // namespace shlm
