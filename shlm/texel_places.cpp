#include "shlm/texel_places.h"

#include <cmath>

namespace shlm {

TexelPlaces::TexelPlaces(const TexelLayout& layout)
    : regions_(layout.regions().begin(), layout.regions().end()), triangles_(layout.triangle_count()) {
    const auto rounded = [](float position, std::uint32_t count) {
        const float share = std::clamp(position / static_cast<float>(count), 0.0f, 1.0f);
        return static_cast<std::uint16_t>(std::lround(share * 0xffff));
    };
    for (std::uint32_t t = 0; t < layout.triangle_count(); ++t) {
        const TriangleTexels& texels = layout.triangle(t);
        if (texels.width == 0) continue;
        triangles_[t].region = static_cast<std::uint32_t>(layout.region_of(t));
        const std::array<common::Vec2, 3> corners = {texels.corner, texels.corner + texels.edge_u,
                                                     texels.corner + texels.edge_v};
        for (std::size_t i = 0; i < 3; ++i) {
            triangles_[t].corner[2 * i] = rounded(corners[i].x, texels.width);
            triangles_[t].corner[2 * i + 1] = rounded(corners[i].y, texels.height);
        }
    }
}

}  // namespace shlm
