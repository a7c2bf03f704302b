// The places of texels in a picture: the regions' rectangles side by side.
#pragma once

#include "shlm/layout/texel_layout.h"

namespace shlm {

/// Places rectangles by falling height, on shelves as wide as the square root of all pixels or the widest
/// rectangle. The places depend on the layout and the gutter alone.
class TexelAtlas {
  public:
    /// One face of a region; `left` and `top` are the pixel of its first texel.
    struct Rectangle {
        std::uint32_t first_texel, width, height;
        std::uint32_t left = 0, top = 0;
    };

    /// `gutter`: free pixels on each side of every rectangle.
    explicit TexelAtlas(const TexelLayout& layout, std::uint32_t gutter = 0);

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }
    [[nodiscard]] std::uint32_t gutter() const { return gutter_; }

    /// In the layout's order of texels: the front of each region, then its back where it has one.
    [[nodiscard]] std::span<const Rectangle> rectangles() const { return rectangles_; }

    /// The rectangle that begins with this texel.
    [[nodiscard]] const Rectangle& rectangle(std::uint32_t first_texel) const {
        return *std::lower_bound(
            rectangles_.begin(), rectangles_.end(), first_texel,
            [](const Rectangle& r, std::uint32_t texel) { return r.first_texel < texel; });
    }

    /// Calls `visit(texel, pixel)` for all texels; pixels count row by row from the top left one.
    template <class Visit>
    void for_each(Visit visit) const {
        for (const Rectangle& r : rectangles_)
            for (std::uint32_t y = 0; y < r.height; ++y)
                for (std::uint32_t x = 0; x < r.width; ++x)
                    visit(std::size_t{r.first_texel} + std::size_t{y} * r.width + x,
                          (std::size_t{r.top} + y) * width_ + r.left + x);
    }

  private:
    std::vector<Rectangle> rectangles_;
    std::uint32_t width_ = 1, height_ = 1, gutter_;
};

}  // namespace shlm
