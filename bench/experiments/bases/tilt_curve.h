// Irradiance as the normal tilts, in the light of one lamp.
#pragma once

#include "bench/experiments/bases/basis.h"

namespace bench::bases {

/// In the plane of the light; relative to a plane that faces it.
struct TiltCurve {
    double light_degrees;  ///< of the light from the geometric normal
    std::vector<double>
        degrees;  ///< of the shading normal from the geometric one, positive towards the light
    std::vector<double> truth;
    std::vector<BasisAnswers> answers;  ///< one for each of all_bases()
};

[[nodiscard]] TiltCurve measure_tilt_curve();

}  // namespace bench::bases
