#include "bench/app/warnings.h"

#include <fmt/format.h>

namespace bench {

void print_warning(const LoadedScene& scene, const std::string& text) {
    fmt::print(stderr, "{}: warning: {}\n", scene.name, text);
}

std::vector<std::string> scene_warnings(const LoadedScene& scene) {
    std::vector<std::string> lines = scene.scene.warnings;
    const common::CoincidingTriangles& coinciding = scene.rays.coinciding_triangles();
    if (coinciding.covering > 0)
        lines.push_back(fmt::format(
            "{}{} triangles ({:.3g} m^2) lie over others in the same plane: where they do, the first in the "
            "file is met, but lamps before others and what lets light through after them",
            coinciding.all_compared ? "" : "at least ", coinciding.covering, coinciding.area));
    return lines;
}

void print_scene_warnings(const LoadedScene& scene) {
    for (const std::string& line : scene_warnings(scene)) print_warning(scene, line);
}

void print_lightmap_warnings(const LoadedScene& scene, const PreparedMethods& prepared) {
    for (const std::string& line : prepared.lightmap_trouble()) print_warning(scene, line);
}

}  // namespace bench
