// shlmbench stability: the collection of failure cases.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_stability_command(CLI::App& app);

}  // namespace bench
