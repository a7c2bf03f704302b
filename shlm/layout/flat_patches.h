// Finds triangles of a mesh that can be flattened together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// Triangles whose normals differ by up to 25 degrees may be in one patch.
inline constexpr float same_patch_cosine = 0.9f;

struct FlatPatch {
    common::Vec3 normal;                  ///< unit, of its plane
    std::vector<std::uint32_t> triangle;  ///< of the scene
};

/// Returns parts of a mesh's surface, given by triangles of the scene, that are flat to texels of this size
/// (world units). The triangles of a part are connected by edges, their normals are within 25 degrees of the
/// largest one's, and they stay within half a texel of its plane. So triangles that overlap in a patch are
/// the same place to a texel. Each triangle is in one patch; those without area are in none.
[[nodiscard]] std::vector<FlatPatch> flat_patches(const common::Scene& scene,
                                                  std::span<const std::uint32_t> triangles,
                                                  double texel_size);

}  // namespace shlm
