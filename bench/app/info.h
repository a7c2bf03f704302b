// shlmbench info: what is in a scene and what the methods can do with it.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_info_command(CLI::App& app);

}  // namespace bench
