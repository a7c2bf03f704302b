// The option for how the photons of a run are spread.
#pragma once

#include "bench/setup/command.h"
#include "common/core/input_error.h"
#include "common/tracer/photon_source.h"

namespace bench {

struct EmissionOption {
    std::string emission = "random";

    void add_to(Command& command) {
        command.option("--emission", emission,
                       "random: photons leave their lights independently; sobol: by a scrambled Sobol' "
                       "sequence, most evenly where their number is a power of two");
    }

    /// Throws InputError for values without a meaning.
    [[nodiscard]] common::EmissionSequence sequence() const {
        if (emission == "random") return common::EmissionSequence::random;
        if (emission == "sobol") return common::EmissionSequence::sobol;
        throw common::InputError("--emission: '" + emission + "' is neither random nor sobol");
    }
};

}  // namespace bench
