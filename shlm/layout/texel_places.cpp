#include "shlm/layout/texel_places.h"

#include <cmath>

namespace shlm {
namespace {

std::uint16_t rounded(float position, std::uint32_t count) {
    const float share = std::clamp(position / static_cast<float>(count), 0.0f, 1.0f);
    return static_cast<std::uint16_t>(std::lround(share * 0xffff));
}

}  // namespace

TexelPlaces::TexelPlaces(const TexelLayout& layout)
    : regions_(layout.regions().begin(), layout.regions().end()),
      planes_(layout.planes().begin(), layout.planes().end()),
      region_of_(layout.triangle_count(), no_region),
      corners_(planes_.empty() ? layout.triangle_count() : 0) {
    for (std::uint32_t t = 0; t < layout.triangle_count(); ++t) {
        const TriangleTexels& texels = layout.triangle(t);
        if (texels.width == 0) continue;
        region_of_[t] = static_cast<std::uint32_t>(layout.region_of(t));
        if (corners_.empty()) continue;
        const std::array<common::Vec2, 3> corners = {texels.corner, texels.corner + texels.edge_u,
                                                     texels.corner + texels.edge_v};
        for (std::size_t i = 0; i < 3; ++i) {
            corners_[t][2 * i] = rounded(corners[i].x, texels.width);
            corners_[t][2 * i + 1] = rounded(corners[i].y, texels.height);
        }
    }
}

}  // namespace shlm
