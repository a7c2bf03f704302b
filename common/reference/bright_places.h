// Importance sampling of the places on a textured light.
#pragma once

#include <array>
#include <vector>

#include "common/scene/surface_point.h"

namespace common::reference {

/// Importance sampling of a grid over the unit square: cells in proportion to their emission, and uniform
/// within a cell. It inverts the cumulative distribution by row and column, so that strata of the square stay
/// strata.
class BrightPlaces {
  public:
    /// `cell` has the emission of each cell, in `across` rows of `across` cells. At least one must emit.
    BrightPlaces(int across, std::vector<double> cell);

    /// Maps a uniform point of the square to the sampled place in the square.
    [[nodiscard]] std::array<double, 2> place(const std::array<double, 2>& uniform) const;

    /// Returns the density of `place` relative to that of uniform sampling.
    [[nodiscard]] double density(const std::array<double, 2>& place) const;

  private:
    int across_;
    std::vector<double> in_row_;   ///< cumulative sums within each row
    std::vector<double> of_rows_;  ///< cumulative sums of rows
};

/// Returns the emitted radiance of each cell of a triangle, holes counted as 0, W/(m^2 sr), mean over the
/// channels. It is estimated at a few places of the cell. place_on() maps the square to the triangle.
[[nodiscard]] std::vector<double> emission_grid(const Scene& scene, std::uint32_t triangle, int across);

/// Returns how many cells across, from 1 to `most`, make a cell about a texel of the triangle's emissive
/// texture.
[[nodiscard]] int cells_across(const Scene& scene, std::uint32_t triangle, int most);

}  // namespace common::reference
