// shlmbench study: error beside time and bytes, over methods, hits and seeds.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_study_command(CLI::App& app);

}  // namespace bench
