// shlmbench reference: what the methods estimate, by path tracing, with its error.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_reference_command(CLI::App& app);

}  // namespace bench
