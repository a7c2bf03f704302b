// Patterns of the materials: albedo and relief of walls, floors and cloth.
#pragma once

#include "bench/scenes/procedural_texture.h"

namespace scenes {

/// One tile of a pattern.
struct SurfacePattern {
    Albedo albedo;
    Height height;  ///< empty where the surface is flat
};

/// Blocks in running bond (every second course shifted by half a block) with recessed joints.
struct Masonry {
    int columns, courses;
    bool running_bond;
    float joint;        ///< width, in tile widths
    float relief;       ///< depth of the joint, in tile widths
    Rgb block, mortar;  ///< albedo
    float variation;    ///< of the blocks' albedo, as a fraction
};
[[nodiscard]] SurfacePattern masonry(const Masonry& masonry);

[[nodiscard]] SurfacePattern plaster(const Rgb& albedo);  ///< nearly flat, faint stains
[[nodiscard]] SurfacePattern marble(const Rgb& albedo);   ///< veined, polished: flat
[[nodiscard]] SurfacePattern wood(const Rgb& albedo);     ///< boards with grain along v
[[nodiscard]] SurfacePattern cloth();  ///< near-white weave, to be tinted by the base colour factor

/// Returns spherical caps in a square grid; a `radius_fraction` of 1 makes neighbours touch.
/// `steepest_slope`, in radians, is that of the caps' rims.
[[nodiscard]] Height domes(int per_side, float radius_fraction, float steepest_slope);

/// Returns sinusoidal ridges along v with the slope `steepest_slope` in radians.
[[nodiscard]] Height ridges(int per_tile, float steepest_slope);

}  // namespace scenes
