// The options that set what a method's name leaves open.
#pragma once

#include <string>

#include "bench/contenders/contender.h"
#include "bench/setup/command.h"

namespace bench {

struct MethodOptions {
    TexelOptions texels;
    double max_radius = 0;

    void add_to(Command& command);

    /// Throws InputError for values that mean nothing.
    [[nodiscard]] ContenderSettings settings() const;
};

}  // namespace bench
