// Which texels are of a point's own surface.
#pragma once

#include <span>
#include <vector>

#include "common/scene/surface_pieces.h"
#include "shlm/layout/texel_geometry.h"

namespace shlm {

/// The surface pieces of a scene, as a light map's texels know them.
class TexelPieces {
  public:
    TexelPieces(common::SurfacePieces pieces, const TexelLayout& layout,
                std::span<const TexelGeometry> texels);

    /// The piece whose texels answer for points on a triangle: its own, or where that is too small to have
    /// texels, the one that the texel in the triangle's middle is of.
    [[nodiscard]] std::uint32_t of_triangle(std::uint32_t triangle) const { return of_triangle_[triangle]; }

    /// Whether texels of one piece answer for points of the other: both are one, or share an edge.
    [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const { return pieces_.meet(a, b); }

    [[nodiscard]] std::size_t bytes() const {
        return pieces_.bytes() + of_triangle_.capacity() * sizeof(std::uint32_t);
    }

  private:
    common::SurfacePieces pieces_;
    std::vector<std::uint32_t> of_triangle_;
};

}  // namespace shlm
