// Triangles that a file contains more than once at the same place.
#pragma once

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Leaves out duplicate triangles: those with the same three positions, bit by bit, and the same winding. One
/// of each set of duplicates is kept: the first opaque one in the file, but an emitter is preferred to
/// others, and then a double-sided one. If none is opaque, one of glass is kept, and all that have holes.
/// Instances left without a triangle are left out too.
///
/// A scene without duplicates is not changed.
void leave_out_duplicates(Scene& scene, Warnings& warnings);

}  // namespace common::gltf
