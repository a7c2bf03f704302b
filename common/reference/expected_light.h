// The irradiance expected from a light before its visibility is known.
#pragma once

#include "common/reference/light.h"
#include "common/reference/receiver.h"

namespace common::reference {

/// Returns an estimate of the irradiance from the light at the receiver if nothing is between them, W/m^2,
/// mean over the channels. It is 0 only if the light contributes nothing, or must not be chosen (area_light).
[[nodiscard]] double expected_irradiance(const Light& light, const Receiver& receiver);

}  // namespace common::reference
