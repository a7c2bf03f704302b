// shlmbench info: what is in a scene and what the methods can do with it.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_info_command(CLI::App& app);

}  // namespace bench
