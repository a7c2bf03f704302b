// shlmbench render: one method's picture of a scene.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_render_command(CLI::App& app);

}  // namespace bench
