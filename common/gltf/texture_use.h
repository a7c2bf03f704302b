// How a material reads a texture: through which coordinates, moved how (KHR_texture_transform).
#pragma once

#include <tiny_gltf.h>

#include "common/scene/scene.h"

namespace common::gltf {

/// The set of texture coordinates that a textureInfo names; the extension's wins. May be any number >= 0.
[[nodiscard]] int texcoord_set(int given, const tinygltf::ExtensionMap& extensions);

/// Where a textureInfo's texture coordinates are taken to. A positive rotation turns them counter-clockwise
/// as an image is looked at, from u (right) to -v (up), so the image turns clockwise on the surface.
[[nodiscard]] TexcoordTransform texcoord_transform(const tinygltf::ExtensionMap& extensions);

}  // namespace common::gltf
