// shlmbench limit: how near tracing comes to what Embree alone does with the same rays.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_limit_command(CLI::App& app);

}  // namespace bench
