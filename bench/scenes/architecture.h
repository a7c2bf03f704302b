// The building blocks of the atrium, each in its own coordinates and meant to be placed many times.
#pragma once

#include "bench/scenes/mesh_builder.h"

namespace scenes {

/// What columns, arches and piers agree on, in metres.
namespace arcade {
inline constexpr float bay = 3.5f;             ///< from column axis to column axis
inline constexpr float abacus = 0.7f;          ///< side of the block on a column and the one below it
inline constexpr float arch_radius = 1.4f;     ///< so that arch and abacus fill the bay
inline constexpr float wall_thickness = 0.5f;  ///< of the wall over the arches
inline constexpr float wall_height = 2.0f;     ///< from the springing of the arches to the top of their wall
inline constexpr float rail_height = 0.95f;    ///< of the balustrade
}  // namespace arcade

/// Stands on the origin; `height` to the top of its abacus.
[[nodiscard]] Mesh make_fluted_column(float height);
[[nodiscard]] Mesh make_slender_column(float height);

/// Wall of one bay with a round arch, along x. The origin is in the middle between the columns at the height
/// of their tops. The top edge and both ends are open: they meet the ceiling and the next bay.
[[nodiscard]] Mesh make_arch_bay();

/// Square corner of the arcade with two half-pillars for the arches that end here, towards -x and -z.
/// The origin is on the floor at the corner of the court.
[[nodiscard]] Mesh make_corner_pier(float springing_height);

/// Plinth, balusters and rail between two columns, along x; the origin is in the middle on the floor.
[[nodiscard]] Mesh make_balustrade_bay();

/// Moulding round the inside of a rectangular opening, between two heights; it closes the edge of a floor.
[[nodiscard]] Mesh make_cornice(float half_x, float half_z, float bottom, float top);

}  // namespace scenes
