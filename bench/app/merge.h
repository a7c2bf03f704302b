// shlmbench merge: light maps of adjoining photons into one.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_merge_command(CLI::App& app);

}  // namespace bench
