#include "shlm/file/texel_atlas.h"

#include <numeric>

namespace shlm {

TexelAtlas::TexelAtlas(const TexelLayout& layout, std::uint32_t gutter) : gutter_(gutter) {
    double pixels = 0;
    for (const TexelRegion& region : layout.regions()) {
        const double wide = region.width + 2.0 * gutter, high = region.height + 2.0 * gutter;
        for (const bool back : {false, true}) {
            if (back && !region.both_faces) continue;
            rectangles_.push_back({region.first_texel_of(back), region.width, region.height});
            pixels += wide * high;
        }
        width_ = std::max(width_, region.width + 2 * gutter);
    }
    width_ = std::max(width_, static_cast<std::uint32_t>(std::ceil(std::sqrt(pixels))));

    std::vector<std::size_t> order(rectangles_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rectangles_[a].height > rectangles_[b].height;
    });
    std::uint32_t left = 0, top = 0, bottom = 0;
    for (const std::size_t i : order) {
        Rectangle& rectangle = rectangles_[i];
        const std::uint32_t wide = rectangle.width + 2 * gutter, high = rectangle.height + 2 * gutter;
        if (left + wide > width_) {
            left = 0;
            top = bottom;
        }
        rectangle.left = left + gutter;
        rectangle.top = top + gutter;
        left += wide;
        bottom = std::max(bottom, top + high);
    }
    height_ = std::max(height_, bottom);
}

}  // namespace shlm
