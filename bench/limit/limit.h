// shlmbench limit: how near tracing comes to what Embree alone does with the same rays.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_limit_command(CLI::App& app);

}  // namespace bench
