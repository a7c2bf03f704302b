#include "shlm/layout/texel_pieces.h"

namespace shlm {

TexelPieces::TexelPieces(common::SurfacePieces pieces, const TexelLayout& layout,
                         std::span<const TexelGeometry> texels)
    : pieces_(std::move(pieces)), of_triangle_(layout.triangle_count()) {
    std::vector<bool> has_texels(pieces_.count(), false);
    for (const TexelGeometry& texel : texels)
        if (texel.area > 0) has_texels[texel.piece] = true;
    for (std::uint32_t t = 0; t < of_triangle_.size(); ++t) {
        const TriangleTexels& placed = layout.triangle(t);
        of_triangle_[t] = pieces_.of_triangle(t);
        if (has_texels[of_triangle_[t]] || placed.width == 0) continue;
        const TexelGeometry& middle = texels[texel_at(placed, 1.0f / 3, 1.0f / 3, true)];
        if (middle.area > 0) of_triangle_[t] = middle.piece;
    }
}

}  // namespace shlm
