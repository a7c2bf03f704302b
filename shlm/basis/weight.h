// The weight of a hit.
#pragma once

namespace shlm {

/// The directional light that a hit of flux F, on texel area a, at incidence theta represents. The paper
/// leaves it open.
enum class ShWeight {
    radiance,   ///< F / (a cos theta): its irradiance on the surface is F / a, as it must be
    flux,       ///< F / a: the paper taken literally; gives two thirds of the irradiance of a uniform
                ///< hemisphere
    normalised  ///< as radiance, but only for the shape: it is scaled so that the surface's own normal gets
                ///< the exact sum of F / a, which is kept as one more number
};

}  // namespace shlm
