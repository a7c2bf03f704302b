// shlmbench merge: light maps of adjoining photons into one.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_merge_command(CLI::App& app);

}  // namespace bench
