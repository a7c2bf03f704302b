// shlmbench stability: the collection of failure cases.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_stability_command(CLI::App& app);

}  // namespace bench
