// The texels of a light map as a picture that can be filtered: with gutters, and without holes.
#pragma once

#include <span>
#include <vector>

#include "shlm/file/texel_atlas.h"
#include "shlm/map/texel_lookup.h"

namespace bench {

/// Pixels around every rectangle. Bilinear filtering at a coordinate within the rectangle reads no farther;
/// the map is not meant to be filtered from smaller copies (mipmaps).
inline constexpr std::uint32_t light_atlas_gutter = 1;

struct LightAtlas {
    shlm::TexelAtlas places;
    /// One per pixel: the texel whose light it shows. Covered texels show their own; uncovered ones and the
    /// gutter show the nearest covered one of their rectangle. shlm::no_texel where a rectangle has none, and
    /// between rectangles.
    std::vector<std::uint32_t> shown;

    [[nodiscard]] std::size_t pixel_count() const { return shown.size(); }
};

/// `face`: of the layout's texels; those without area are uncovered.
[[nodiscard]] LightAtlas make_light_atlas(const shlm::TexelLayout& layout,
                                          std::span<const shlm::TexelFace> face);

}  // namespace bench
