// Loads a glTF 2.0 file into a Scene.
#pragma once

#include <filesystem>

#include "common/scene/scene.h"

namespace common {

/// Reads a .gltf or .glb file and moves its mesh instances to world space: those of its default scene, else
/// of its first scene, else of all its nodes.
///
/// Reads triangle lists, strips and fans, materials (gltf/materials.h says which surface each becomes),
/// KHR_lights_punctual (candela taken as W/sr, lux as W/m^2) and perspective cameras. Reads skins and morph
/// targets in their pose without animation. Zero-area triangles are left out and counted in Scene::warnings.
/// Everything else that is read but not honoured has a warning there, each extension with its name. Only the
/// missing metallic or glossy reflection of a diffuse surface has none.
///
/// Throws InputError, with the file and the error in one line, in these cases: the file is missing, truncated
/// or not glTF 2.0; indices or ranges point outside their target; a buffer or a needed image cannot be read;
/// positions or transforms are not finite; nodes form a loop; an extension is required but not drawn; meshes
/// or textures exist in compressed form only; the scene has no triangles.
[[nodiscard]] Scene load_gltf(const std::filesystem::path& file);

}  // namespace common
