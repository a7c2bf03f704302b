// shlmbench diff: how far an image is from a reference.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_diff_command(CLI::App& app);

}  // namespace bench
