// What a user should know of a scene before its results are looked at, a line each on stderr.
#pragma once

#include <string>
#include <vector>

#include "bench/app/methods.h"

namespace bench {

void print_warning(const LoadedScene& scene, const std::string& text);

/// What its file asks for and does not get, and where it leaves open what is there.
[[nodiscard]] std::vector<std::string> scene_warnings(const LoadedScene& scene);
void print_scene_warnings(const LoadedScene& scene);

/// What stands in the way of light maps.
void print_lightmap_warnings(const LoadedScene& scene, const PreparedMethods& prepared);

}  // namespace bench
