// The options that set the methods, as commands take them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "bench/app/methods.h"

namespace bench {

struct MethodOptions {
    std::string texels = "262144";
    std::string sh_weight = "radiance";
    std::size_t gather_texels = 4;
    std::size_t k = 50;
    double max_radius = 0;
    double cone = 0;

    void add_to(CLI::App& command);

    /// Throws InputError for values that mean nothing.
    [[nodiscard]] MethodSettings settings() const;
};

}  // namespace bench
