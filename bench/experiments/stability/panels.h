// Pictures of a case: the answers of several methods on one square, side by side.
#pragma once

#include <array>

#include "common/core/vector.h"
#include "common/image/image.h"

namespace bench::stability {

/// Draws the panels. `answers(x, y)` returns one colour per panel; x and y go from 0 to 1, right and down.
template <std::size_t Panels, class Answers>
[[nodiscard]] common::Image panels_side_by_side(Answers answers) {
    constexpr int size = 192, width = static_cast<int>(Panels) * size;
    common::Image image{width, size, {"R", "G", "B"}, {}};
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < width; ++column) {
            const std::array<common::Rgb, Panels> all =
                answers((column % size + 0.5) / size, (row + 0.5) / size);
            const common::Rgb& answer = all[static_cast<std::size_t>(column / size)];
            image.values.insert(image.values.end(), {answer.x, answer.y, answer.z});
        }
    return image;
}

}  // namespace bench::stability
