// Cloth, vessels and other things that furnish the atrium.
#pragma once

#include "bench/scenes/mesh_builder.h"

namespace scenes {

/// A curtain on a rod along x, gathered at `tie_height` towards the column at its left.
/// A single sheet: its material is double-sided. The origin is on the floor below the left end of the rod.
[[nodiscard]] Mesh make_tied_curtain(float rod_height, float width, float tie_height);

/// A banner that hangs from the origin down the plane z = 0, waving a little. A single sheet.
[[nodiscard]] Mesh make_banner(float width, float height);

/// Stands on the origin; open at the top, with an inside.
[[nodiscard]] Mesh make_vase(float height);

/// Round pedestal on the origin.
[[nodiscard]] Mesh make_pedestal(float radius, float height);

/// Tube along a trefoil knot about the origin that reaches `radius` from it.
[[nodiscard]] Mesh make_trefoil_knot(float radius, float tube_radius);

/// Lamp on a rod that hangs from the origin; the light belongs at `pendant_light_height` (negative).
[[nodiscard]] Mesh make_pendant(float rod_length);
[[nodiscard]] float pendant_light_height(float rod_length);

}  // namespace scenes
