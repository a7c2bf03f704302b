#include "bench/export/light_atlas.h"

namespace bench {
namespace {

/// Spreads what is shown from pixel to pixel over one rectangle and its gutter: breadth first, so that each
/// pixel gets the nearest covered texel by steps along rows and columns.
void fill(LightAtlas& atlas, const shlm::TexelAtlas::Rectangle& rectangle,
          std::span<const shlm::TexelFace> face) {
    const std::size_t width = atlas.places.width(), gutter = atlas.places.gutter();
    const std::size_t left = rectangle.left - gutter, right = rectangle.left + rectangle.width + gutter;
    const std::size_t top = rectangle.top - gutter, bottom = rectangle.top + rectangle.height + gutter;
    std::vector<std::size_t> reached;
    for (std::uint32_t y = 0; y < rectangle.height; ++y)
        for (std::uint32_t x = 0; x < rectangle.width; ++x) {
            const std::uint32_t texel = rectangle.first_texel + y * rectangle.width + x;
            if (face[texel].area == 0) continue;
            reached.push_back((std::size_t{rectangle.top} + y) * width + rectangle.left + x);
            atlas.shown[reached.back()] = texel;
        }
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const std::size_t pixel = reached[i], x = pixel % width, y = pixel / width;
        const auto spread = [&](bool inside, std::size_t neighbour) {
            if (!inside || atlas.shown[neighbour] != shlm::no_texel) return;
            atlas.shown[neighbour] = atlas.shown[pixel];
            reached.push_back(neighbour);
        };
        spread(x > left, pixel - 1);
        spread(x + 1 < right, pixel + 1);
        spread(y > top, pixel - width);
        spread(y + 1 < bottom, pixel + width);
    }
}

}  // namespace

LightAtlas make_light_atlas(const shlm::TexelLayout& layout, std::span<const shlm::TexelFace> face) {
    LightAtlas atlas{shlm::TexelAtlas(layout, light_atlas_gutter), {}};
    atlas.shown.assign(std::size_t{atlas.places.width()} * atlas.places.height(), shlm::no_texel);
    for (const shlm::TexelAtlas::Rectangle& rectangle : atlas.places.rectangles())
        fill(atlas, rectangle, face);
    return atlas;
}

}  // namespace bench
