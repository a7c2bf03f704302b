// Importance sampling of the places where a triangle's emissive texture is bright.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <vector>

#include "common/scene/scene.h"

namespace common {

/// Bounds the brightness in any rectangle of a texture by the brightest texel in it or, to save time, near
/// it. The bound is 0 only where the texture is black, and always there if the rectangle is small enough.
class BrightestTexels {
  public:
    explicit BrightestTexels(const Texture& texture);

    /// Returns an upper bound of all channels between two texture coordinates, as a fraction of full
    /// brightness.
    [[nodiscard]] float within(const Vec2& low, const Vec2& high) const;

  private:
    struct Level {
        int width, height;
        std::vector<std::uint8_t> brightest;  ///< of 2^level x 2^level texels, row by row
    };

    [[nodiscard]] std::uint8_t in_texels(int first_x, int last_x, int first_y, int last_y) const;

    std::array<Wrap, 2> wrap_;
    std::vector<Level> level_;  ///< from single texels to one value for all
};

/// A triangle split into equal cells, as fine as its texels or as `most_cells` allows, without cells where
/// the texture is black. Photons start in a cell in proportion to its emission. So all carry about the same
/// flux, and none starts in the dark.
class EmissionCells {
  public:
    /// `brightest` belongs to the material's emissive texture. About `most_cells` are kept, at most four
    /// times as many.
    EmissionCells(const Scene& scene, std::uint32_t triangle, const BrightestTexels& brightest,
                  std::size_t most_cells);

    /// Returns the mean over the triangle, from samples in each cell. A hundredth of a cell's weight comes
    /// from its brightest texel, so that light between the samples is not lost. It is 0 only if the texture
    /// is black.
    [[nodiscard]] const Rgb& mean_radiance() const { return mean_radiance_; }

    struct Place {
        Vec2 uv;        ///< barycentric, of the second and third corner
        float density;  ///< relative to uniform density over the triangle
    };

    /// Returns the place for numbers that are uniform in [0, 1). The triangle must not be black.
    [[nodiscard]] Place place(double which, float u1, float u2) const;

  private:
    /// Has its corners at (column, row), (column + 1, row) and (column, row + 1) over 2^level; if turned, at
    /// (column + 1, row + 1), (column, row + 1) and (column + 1, row).
    struct Cell {
        std::uint16_t column, row;
        bool turned;
    };

    [[nodiscard]] Vec2 within(const Cell& cell, const Vec2& uv) const;
    [[nodiscard]] Imath::Box<Vec2> texcoords_of(const Cell& cell) const;
    [[nodiscard]] float texels_along_an_edge(const Texture& texture) const;
    void split();
    void drop_black(const BrightestTexels& brightest);
    void weigh(const Scene& scene, const BrightestTexels& brightest, int samples_across);

    std::uint32_t triangle_;
    std::array<Vec2, 3> texcoord_;  ///< of the corners, in the texture
    int level_ = 0;
    std::vector<Cell> cell_;
    std::vector<double> cumulative_;  ///< sum of the cells' weights, mean over the channels
    Rgb mean_radiance_{0, 0, 0};
};

}  // namespace common
