// The error of a basis relative to the light that it was fitted to.
#pragma once

#include <span>
#include <vector>

#include "bench/experiments/bases/environment.h"

namespace bench::bases {

/// Returns normals such as normal maps make: 300 within 60 degrees of +z, each for the same solid angle.
[[nodiscard]] std::vector<common::Vec3> tilted_normals();

/// Returns the irradiance for each normal, W/m^2, summed over the arrivals. With n the normal and w the
/// direction to the light, an arrival contributes max(0, n.w) E / cos(theta), since E / cos(theta) is the
/// irradiance of a plane that faces the light. Only the red channel is used: colours are random, so all
/// channels are alike over many environments.
[[nodiscard]] std::vector<double> true_irradiance(std::span<const Arrival> arrivals,
                                                  std::span<const common::Vec3> normals);

/// Returns, in %, the root mean square over the normals of (answer - truth), divided by the mean of the
/// truth.
[[nodiscard]] double relative_rms_percent(std::span<const double> answers, std::span<const double> truth);

}  // namespace bench::bases
