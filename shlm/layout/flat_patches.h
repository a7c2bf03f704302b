// Which triangles of a mesh can be laid flat together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// What faces apart by up to 25 degrees may lie in one patch.
inline constexpr float same_patch_cosine = 0.9f;

struct FlatPatch {
    common::Vec3 normal;                  ///< unit, of its plane
    std::vector<std::uint32_t> triangle;  ///< of the scene
};

/// Parts of a mesh's surface, given by triangles of the scene, that texels of this size (world units) take
/// for flat: triangles that hang together edge by edge, whose normals are within 25 degrees of the largest
/// one's, and that stay within half a texel of its plane. What lies over each other in a patch is therefore
/// the same place to a texel. Each triangle is in one patch; those without area are in none.
[[nodiscard]] std::vector<FlatPatch> flat_patches(const common::Scene& scene,
                                                  std::span<const std::uint32_t> triangles,
                                                  double texel_size);

}  // namespace shlm
