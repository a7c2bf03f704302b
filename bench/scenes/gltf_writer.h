// Writes a scene description as binary glTF 2.0.
#pragma once

#include <filesystem>

#include "bench/scenes/scene_description.h"

namespace scenes {

/// Writes the scene with all textures inside the file, which appears completely or not at all. Throws
/// InputError if it cannot be written.
void write_glb(const SceneDescription& scene, const std::filesystem::path& file);

}  // namespace scenes
