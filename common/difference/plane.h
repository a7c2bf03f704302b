// A single image channel, and separable filters on it.
#pragma once

#include <vector>

namespace common {

/// One channel, row by row from the top left pixel.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;  ///< width * height

    Plane(int width_, int height_)
        : width(width_), height(height_), values(static_cast<std::size_t>(width_) * height_) {}

    [[nodiscard]] float* row(int y) { return values.data() + static_cast<std::size_t>(y) * width; }
    [[nodiscard]] const float* row(int y) const {
        return values.data() + static_cast<std::size_t>(y) * width;
    }
};

/// Weights of the pixels at distances -radius ... radius, in that order.
struct Kernel {
    std::vector<float> weights;  ///< 2 radius + 1

    [[nodiscard]] int radius() const { return static_cast<int>(weights.size() / 2); }
};

/// Returns the sum of horizontal(i) vertical(j) plane(x + i, y + j) at each pixel (x, y). Beyond the border
/// the value of the nearest pixel is used.
[[nodiscard]] Plane filtered(const Plane& plane, const Kernel& horizontal, const Kernel& vertical);

}  // namespace common
