// shlmbench bases: what a texel's basis loses at tilted normals, without a scene and without noise.
#pragma once

namespace CLI {
class App;
}

namespace bench {

void add_bases_command(CLI::App& app);

}  // namespace bench
