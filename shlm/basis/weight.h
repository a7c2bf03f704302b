// What a hit stands for.
#pragma once

namespace shlm {

/// What directional light a hit of flux F, on texel area a, at incidence theta stands for. The paper leaves
/// it open.
enum class ShWeight {
    radiance,   ///< F / (a cos theta): its irradiance on the surface is F / a, as it must be
    flux,       ///< F / a: the paper read literally; reads two thirds of a uniform hemisphere
    normalised  ///< as radiance, but only for the shape: scaled so that the surface's own normal gets the
                ///< exact sum of F / a, which is kept as one more number
};

}  // namespace shlm
