// How a material reads a texture: its texture coordinates and their transform (KHR_texture_transform).
#pragma once

#include <tiny_gltf.h>

#include "common/scene/scene.h"

namespace common::gltf {

/// Returns the set of texture coordinates that a textureInfo names; that of the extension overrides it. May
/// be any number >= 0.
[[nodiscard]] int texcoord_set(int given, const tinygltf::ExtensionMap& extensions);

/// Returns the transform of a textureInfo's texture coordinates. A positive rotation turns them
/// counter-clockwise in the image, from u (right) to -v (up), so that the image turns clockwise on the
/// surface.
[[nodiscard]] TexcoordTransform texcoord_transform(const tinygltf::ExtensionMap& extensions);

}  // namespace common::gltf
