// Triangles that a file has more than once at the same place.
#pragma once

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Leaves out triangles whose three positions another has too, in the same sense of rotation, to the last
/// bit: of all that are the same one is kept. That is the first in the file of those that let no light
/// through, but one that emits before others, and then one that is double-sided. Where all let light through,
/// glass is kept once, and what has holes all. Instances without a triangle are left out.
///
/// A scene without such triangles stays as it is.
void leave_out_duplicates(Scene& scene, Warnings& warnings);

}  // namespace common::gltf
