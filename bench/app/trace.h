// shlmbench trace: a light map filled for as long as one likes, kept in a file.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_trace_command(CLI::App& app);

}  // namespace bench
