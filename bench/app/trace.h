// shlmbench trace: a light map filled for as long as one likes, kept in a file.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_trace_command(CLI::App& app);

}  // namespace bench
