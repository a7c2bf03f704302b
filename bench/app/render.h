// shlmbench render: one method's picture of a scene.
#pragma once

#include <CLI/CLI.hpp>

namespace bench {

void add_render_command(CLI::App& app);

}  // namespace bench
