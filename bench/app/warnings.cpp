#include "bench/app/warnings.h"

#include <fmt/format.h>

#include "common/core/standard_streams.h"

namespace bench {

void print_warning(const LoadedScene& scene, const std::string& text) {
    common::say(fmt::format("{}: warning: {}", scene.name, text));
}

void print_scene_warnings(const LoadedScene& scene) {
    for (const std::string& line : scene.scene.warnings) print_warning(scene, line);
}

void print_lightmap_warnings(const LoadedScene& scene, const PreparedMethods& prepared) {
    for (const std::string& line : prepared.lightmap_trouble()) print_warning(scene, line);
}

}  // namespace bench
