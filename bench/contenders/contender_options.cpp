#include "bench/contenders/contender_options.h"

#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "common/core/input_error.h"

namespace bench {

void MethodOptions::add_to(Command& command) {
    texels.add_to(command);
    command.number("--max-radius", max_radius,
                   "Photon maps: largest gather radius; 0: 1/20 of the scene's diagonal");
}

ContenderSettings MethodOptions::settings() const {
    // The square of a smaller radius underflows in float.
    if (max_radius != 0 && !(max_radius >= 1e-15 && max_radius <= 1e9))
        throw common::InputError("--max-radius: 0, or from 1e-15 to 1e9");
    return {texels.choice(), static_cast<float>(max_radius)};
}

}  // namespace bench
