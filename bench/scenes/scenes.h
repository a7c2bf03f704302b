// The project's own scenes. Units are metres, y is up; README.md explains the purpose of each.
#pragma once

#include "bench/scenes/scene_description.h"

namespace scenes {

[[nodiscard]] SceneDescription make_cornell();
[[nodiscard]] SceneDescription make_bumpy();
[[nodiscard]] SceneDescription make_caustic();
[[nodiscard]] SceneDescription make_atrium();

/// Makes a closed room with boxes, shelves, lamps, textures and normal maps, all drawn at random from the
/// seed.
[[nodiscard]] SceneDescription make_random_room(std::uint32_t seed);

}  // namespace scenes
