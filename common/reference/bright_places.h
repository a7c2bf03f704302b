// Which places of a textured light to look at.
#pragma once

#include <array>
#include <vector>

#include "common/scene/surface_point.h"

namespace common::reference {

/// A grid over the unit square whose cells are chosen in proportion to what they emit, and the same again
/// within them by how far a number goes beyond its share: strata of the square stay strata.
class BrightPlaces {
  public:
    /// `cell`: `across` rows of as many, what each emits. At least one must emit.
    BrightPlaces(int across, std::vector<double> cell);

    /// The place for a uniform point of the square, in the square.
    [[nodiscard]] std::array<double, 2> place(const std::array<double, 2>& uniform) const;

    /// Density of `place` over that of uniform places.
    [[nodiscard]] double density(const std::array<double, 2>& place) const;

  private:
    int across_;
    std::vector<double> in_row_;   ///< sums up to and with each cell of its row
    std::vector<double> of_rows_;  ///< sums up to and with each row
};

/// What each cell of a triangle emits, holes included, W/(m^2 sr), mean over the channels, by a look at some
/// of its places. The square lies on the triangle as place_on says.
[[nodiscard]] std::vector<double> emission_grid(const Scene& scene, std::uint32_t triangle, int across);

/// Cells of about a texel of the triangle's emissive texture, from 1 to `most` across.
[[nodiscard]] int cells_across(const Scene& scene, std::uint32_t triangle, int most);

}  // namespace common::reference
