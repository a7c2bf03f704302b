// Curtains, vessels and other furnishings of the atrium.
#pragma once

#include "bench/scenes/mesh_builder.h"

namespace scenes {

/// Makes a curtain on a rod along x, gathered at `tie_height` towards the column at its left. It is a single
/// sheet, so its material is double-sided. The origin is on the floor below the left end of the rod.
[[nodiscard]] Mesh make_tied_curtain(float rod_height, float width, float tie_height);

/// Makes a banner that hangs from the origin in the plane z = 0 and waves a little. It is a single sheet.
[[nodiscard]] Mesh make_banner(float width, float height);

/// Makes a vase that stands on the origin, open at the top and with an inside.
[[nodiscard]] Mesh make_vase(float height);

/// Makes a round pedestal on the origin.
[[nodiscard]] Mesh make_pedestal(float radius, float height);

/// Makes a tube along a trefoil knot about the origin, which reaches `radius` from it.
[[nodiscard]] Mesh make_trefoil_knot(float radius, float tube_radius);

/// Makes a lamp on a rod that hangs from the origin; its light is at height `pendant_light_height`
/// (negative).
[[nodiscard]] Mesh make_pendant(float rod_length);
[[nodiscard]] float pendant_light_height(float rod_length);

}  // namespace scenes
