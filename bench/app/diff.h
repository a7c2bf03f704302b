// shlmbench diff: how far an image is from a reference.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_diff_command(CLI::App& app);

}  // namespace bench
