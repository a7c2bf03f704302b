// shlmbench study: error beside time and bytes, over methods, hits and seeds.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_study_command(CLI::App& app);

}  // namespace bench
