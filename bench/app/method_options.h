// The options that set what a method's name leaves open.
#pragma once

#include <string>

#include "bench/app/methods.h"

namespace CLI {
class App;
}

namespace bench {

struct MethodOptions {
    TexelOptions texels;
    double max_radius = 0;

    void add_to(CLI::App& command);

    /// Throws InputError for values that mean nothing.
    [[nodiscard]] MethodSettings settings() const;
};

}  // namespace bench
