// How much light to expect before looking whether anything is in the way.
#pragma once

#include "common/reference/light.h"
#include "common/reference/receiver.h"

namespace common::reference {

/// A guess at the irradiance that the light brings to the receiver if nothing is between them, W/m^2, mean
/// over the channels: 0 only where it brings none, or is not to be chosen (area_light).
[[nodiscard]] double expected_irradiance(const Light& light, const Receiver& receiver);

}  // namespace common::reference
