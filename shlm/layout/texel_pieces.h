// Relates the texels of a light map to surface pieces.
#pragma once

#include <span>
#include <vector>

#include "common/scene/surface_pieces.h"
#include "shlm/layout/texel_geometry.h"

namespace shlm {

/// The surface pieces of a scene that the texels of a light map belong to.
class TexelPieces {
  public:
    TexelPieces(common::SurfacePieces pieces, const TexelLayout& layout,
                std::span<const TexelGeometry> texels);

    /// Returns the piece whose texels contribute to points on a triangle. It is the triangle's own or, if
    /// that is too small to have texels, that of the texel in the triangle's middle.
    [[nodiscard]] std::uint32_t of_triangle(std::uint32_t triangle) const { return of_triangle_[triangle]; }

    /// Returns whether texels of one piece contribute to points of the other: both are one, or share an edge.
    [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const { return pieces_.meet(a, b); }

    [[nodiscard]] std::size_t bytes() const {
        return pieces_.bytes() + of_triangle_.capacity() * sizeof(std::uint32_t);
    }

  private:
    common::SurfacePieces pieces_;
    std::vector<std::uint32_t> of_triangle_;
};

}  // namespace shlm
