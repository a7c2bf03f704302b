// The parts of the atrium, each in its own coordinates and placed many times.
#pragma once

#include "bench/scenes/mesh_builder.h"

namespace scenes {

/// Dimensions that columns, arches and piers share, in metres.
namespace arcade {
inline constexpr float bay = 3.5f;             ///< from column axis to column axis
inline constexpr float abacus = 0.7f;          ///< side of the block on a column and the one below it
inline constexpr float arch_radius = 1.4f;     ///< so that arch and abacus fill the bay
inline constexpr float wall_thickness = 0.5f;  ///< of the wall over the arches
inline constexpr float wall_height = 2.0f;     ///< from the springing of the arches to the top of their wall
inline constexpr float rail_height = 0.95f;    ///< of the balustrade
}  // namespace arcade

/// Makes a column that stands on the origin; `height` is that of the top of its abacus.
[[nodiscard]] Mesh make_fluted_column(float height);
[[nodiscard]] Mesh make_slender_column(float height);

/// Makes the wall of one bay with a round arch, along x. The origin is midway between the columns, at the
/// height of their tops. The top edge and both ends are open: they meet the ceiling and the next bay.
[[nodiscard]] Mesh make_arch_bay();

/// Makes the square corner pier of the arcade with two half-pillars for the arches that end here, towards -x
/// and -z. The origin is on the floor at the corner of the court.
[[nodiscard]] Mesh make_corner_pier(float springing_height);

/// Makes plinth, balusters and rail between two columns, along x; the origin is midway on the floor.
[[nodiscard]] Mesh make_balustrade_bay();

/// Makes a moulding round the inside of a rectangular opening, between two heights; it covers the edge of a
/// floor.
[[nodiscard]] Mesh make_cornice(float half_x, float half_z, float bottom, float top);

}  // namespace scenes
