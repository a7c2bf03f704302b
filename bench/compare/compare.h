// shlmbench compare: the methods side by side, over scenes and numbers of hits.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_compare_command(CLI::App& app);

}  // namespace bench
