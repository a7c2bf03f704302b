// Where the texels go in a picture: the regions' rectangles side by side.
#pragma once

#include "shlm/layout/texel_layout.h"

namespace shlm {

/// Rectangles by falling height, on shelves as wide as the square root of all texels or the widest rectangle.
/// Depends on the layout alone.
class TexelAtlas {
  public:
    explicit TexelAtlas(const TexelLayout& layout);

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }

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
    /// One face of a region.
    struct Rectangle {
        std::uint32_t first_texel, width, height;
        std::uint32_t left = 0, top = 0;
    };

    std::vector<Rectangle> rectangles_;
    std::uint32_t width_ = 1, height_ = 1;
};

}  // namespace shlm
