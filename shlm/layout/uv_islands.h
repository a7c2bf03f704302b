// Finds the triangles that are connected in the lightmap.
#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// Returns the island of each of the instance's triangles, numbered from 0 in the order of their first
/// triangles. Triangles are of one island if they share an edge whose ends have the same positions and the
/// same coordinates of `texcoord_set` on both sides.
[[nodiscard]] std::vector<std::uint32_t> uv_islands(const common::Scene& scene,
                                                    const common::MeshInstance& instance, int texcoord_set);

}  // namespace shlm
