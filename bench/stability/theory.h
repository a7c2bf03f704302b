// Formulas that several cases predict by.
#pragma once

namespace bench {

/// What a light map of order 2 reads of a directional light, 1 W/m^2 on a plane that faces it, for a normal
/// at this cosine to it (Ramamoorthi and Hanrahan 2001): bands 0, 1 and 2 of the clamped cosine, 1/4 + x/2 +
/// (5/64) (3 x^2 - 1) 2. The truth is x.
[[nodiscard]] constexpr double order_2_series(double x) {
    return (3 + 16 * x + 15 * x * x) / 32;
}

}  // namespace bench
