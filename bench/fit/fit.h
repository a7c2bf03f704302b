// shlmbench fit: the settings that reach an error at least cost, found without a reference.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_fit_command(CLI::App& app);

}  // namespace bench
