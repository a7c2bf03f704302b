// The project's own scenes. Units are metres, y is up; README.md says what each is for.
#pragma once

#include "bench/scenes/scene_description.h"

namespace scenes {

[[nodiscard]] SceneDescription make_cornell();
[[nodiscard]] SceneDescription make_bumpy();
[[nodiscard]] SceneDescription make_caustic();
[[nodiscard]] SceneDescription make_atrium();

}  // namespace scenes
