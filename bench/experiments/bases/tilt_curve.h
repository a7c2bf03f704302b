// Irradiance as a function of the normal's tilt, for one lamp.
#pragma once

#include "bench/experiments/bases/basis.h"

namespace bench::bases {

/// Normals tilt in the plane of the light. Values are relative to a plane that faces the light.
struct TiltCurve {
    double light_degrees;  ///< angle of the light from the geometric normal
    std::vector<double>
        degrees;  ///< of the shading normal from the geometric one, positive towards the light
    std::vector<double> truth;
    std::vector<BasisAnswers> answers;  ///< one for each of all_bases()
};

[[nodiscard]] TiltCurve measure_tilt_curve();

}  // namespace bench::bases
