#include "bench/app/method_options.h"

#include <CLI/CLI.hpp>

#include "bench/app/number_options.h"
#include "common/core/input_error.h"

namespace bench {

void MethodOptions::add_to(CLI::App& command) {
    texels.add_to(command);
    add_number(command, "--max-radius", max_radius,
               "Photon maps: largest gather radius; 0: 1/20 of the scene's diagonal")
        ->default_str("0");
}

MethodSettings MethodOptions::settings() const {
    // The square of a smaller one is nothing in float.
    if (max_radius != 0 && !(max_radius >= 1e-15 && max_radius <= 1e9))
        throw common::InputError("--max-radius: 0, or from 1e-15 to 1e9");
    return {texels.choice(), static_cast<float>(max_radius)};
}

}  // namespace bench
