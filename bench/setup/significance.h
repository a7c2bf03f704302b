// Bounds for random quantities with a declared false alarm probability.
#pragma once

namespace bench {

/// Returns how many standard deviations a normal variable exceeds, on either side, with probability `alpha`.
[[nodiscard]] double z_for(double alpha);

/// Returns the probability that Student's t with so many degrees of freedom exceeds `t` on either side.
[[nodiscard]] double student_tail(double t, int degrees_of_freedom);

/// Returns how many standard deviations a normal variable exceeds, on either side, with probability `alpha`,
/// if the deviation is estimated with so many degrees of freedom.
[[nodiscard]] double t_for(double alpha, int degrees_of_freedom);

}  // namespace bench
