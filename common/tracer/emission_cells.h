// Where on a triangle its emissive texture shines.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <vector>

#include "common/scene/scene.h"

namespace common {

/// For any rectangle of a texture, the brightest texel in it or, at little cost, near it: 0 only where the
/// texture is black, and there always 0 as soon as the rectangle is small enough.
class BrightestTexels {
  public:
    explicit BrightestTexels(const Texture& texture);

    /// At least what any channel has anywhere between two texture coordinates, as a part of full brightness.
    [[nodiscard]] float within(const Vec2& low, const Vec2& high) const;

  private:
    struct Level {
        int width, height;
        std::vector<std::uint8_t> brightest;  ///< of 2^level texels each way, row by row
    };

    [[nodiscard]] std::uint8_t in_texels(int first_x, int last_x, int first_y, int last_y) const;

    std::array<Wrap, 2> wrap_;
    std::vector<Level> level_;  ///< the texels themselves first, one for all last
};

/// A triangle cut into equal small ones, as fine as its texels or as `most_cells` allows, without those that
/// the texture leaves black. Photons start in a cell in proportion to what it emits, so that each carries
/// about as much and none is spent on the dark.
class EmissionCells {
  public:
    /// `brightest` is that of the material's emissive texture. About `most_cells` are kept, four times as
    /// many at most.
    EmissionCells(const Scene& scene, std::uint32_t triangle, const BrightestTexels& brightest,
                  std::size_t most_cells);

    /// Over the triangle, from samples in each cell. Of what may be bright between the samples a cell has a
    /// hundredth in its chance, so that nothing is lost. 0 only where the texture is black.
    [[nodiscard]] const Rgb& mean_radiance() const { return mean_radiance_; }

    struct Place {
        Vec2 uv;        ///< barycentric, of the second and third corner
        float density;  ///< times that of a place uniform over the triangle
    };

    /// For numbers that are uniform in [0, 1). Not for a black triangle.
    [[nodiscard]] Place place(double which, float u1, float u2) const;

  private:
    /// Corners at (column, row), (column + 1, row) and (column, row + 1) over 2^level; turned ones at
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
