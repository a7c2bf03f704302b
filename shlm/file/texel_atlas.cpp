#include "shlm/file/texel_atlas.h"

namespace shlm {

TexelAtlas::TexelAtlas(const TexelLayout& layout) {
    for (const TexelRegion& region : layout.regions()) {
        rectangles_.push_back({region.first_texel, region.width, region.height});
        if (region.both_faces)
            rectangles_.push_back({region.first_texel_of(true), region.width, region.height});
        width_ = std::max(width_, region.width);
    }
    std::stable_sort(rectangles_.begin(), rectangles_.end(),
                     [](const Rectangle& a, const Rectangle& b) { return a.height > b.height; });
    width_ = std::max(
        width_, static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(layout.texel_count())))));
    std::uint32_t left = 0, top = 0, bottom = 0;
    for (Rectangle& rectangle : rectangles_) {
        if (left + rectangle.width > width_) {
            left = 0;
            top = bottom;
        }
        rectangle.left = left;
        rectangle.top = top;
        left += rectangle.width;
        bottom = std::max(bottom, top + rectangle.height);
    }
    height_ = std::max(height_, bottom);
}

}  // namespace shlm
