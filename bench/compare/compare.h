// shlmbench compare: the methods side by side, over scenes and numbers of hits.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_compare_command(CLI::App& app);

}  // namespace bench
