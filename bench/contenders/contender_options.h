// The options for settings that a method's name does not determine.
#pragma once

#include <string>

#include "bench/contenders/contender.h"
#include "bench/setup/command.h"

namespace bench {

struct MethodOptions {
    TexelOptions texels;
    double max_radius = 0;

    void add_to(Command& command);

    /// Throws InputError for values without a meaning.
    [[nodiscard]] ContenderSettings settings() const;
};

}  // namespace bench
