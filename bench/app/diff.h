// shlmbench diff: how far an image is from a reference.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace bench {

/// All went well, and a result is beyond the bound that the user set. The command exits with 1.
class BoundExceeded : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

void add_diff_command(CLI::App& app);

}  // namespace bench
