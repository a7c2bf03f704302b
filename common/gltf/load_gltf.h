// glTF 2.0 file -> Scene.
#pragma once

#include <filesystem>

#include "common/scene/scene.h"

namespace common {

/// Reads a .gltf or .glb file with all its mesh instances moved to world space: the default scene of the
/// file, else its first, else all its nodes.
///
/// Read are triangle lists, strips and fans, materials (gltf/materials.h says which surface each becomes),
/// KHR_lights_punctual (candela taken as W/sr, lux as W/m^2) and perspective cameras; skins and morph targets
/// as they are where no animation plays. Zero-area triangles are left out and counted in Scene::warnings, as
/// is everything else that is read but not honoured, each extension with its name. That a diffuse surface has
/// no metallic or glossy reflection goes without a warning.
///
/// Throws InputError, with the file and what is wrong with it in one line, for a file that is missing,
/// truncated or not glTF 2.0, for indices and ranges that point outside their target, for a buffer or a
/// needed image that cannot be read, for positions and transforms that are not finite, for nodes in a loop,
/// for an extension that is required but not drawn, for meshes and textures that are there in compressed form
/// only, and for a scene without triangles.
[[nodiscard]] Scene load_gltf(const std::filesystem::path& file);

}  // namespace common
