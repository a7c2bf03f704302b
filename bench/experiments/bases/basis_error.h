// How far a basis is from the light that it was given.
#pragma once

#include <span>
#include <vector>

#include "bench/experiments/bases/environment.h"

namespace bench::bases {

/// The normals that normal maps make: 300 within 60 degrees of +z, each for the same solid angle.
[[nodiscard]] std::vector<common::Vec3> tilted_normals();

/// Irradiance of each normal, W/m^2, summed over the arrivals: E / cos(theta) is what a plane that faces the
/// light gets, max(0, n.w) of that is the normal's. Of the red channel: colours are random, so that all
/// channels are alike over many environments.
[[nodiscard]] std::vector<double> true_irradiance(std::span<const Arrival> arrivals,
                                                  std::span<const common::Vec3> normals);

/// In %: the root mean square over the normals of (answer - truth), divided by the mean of the truth.
[[nodiscard]] double relative_rms_percent(std::span<const double> answers, std::span<const double> truth);

}  // namespace bench::bases
