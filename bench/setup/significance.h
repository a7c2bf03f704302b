// Bounds for random quantities, from a declared chance of failing by accident.
#pragma once

namespace bench {

/// How many standard deviations a normal variable exceeds, to either side, with probability `alpha`.
[[nodiscard]] double z_for(double alpha);

/// Probability that Student's t with so many degrees of freedom exceeds `t` to either side.
[[nodiscard]] double student_tail(double t, int degrees_of_freedom);

/// How many standard deviations, estimated from one value more than there are degrees of freedom, a normal
/// variable exceeds, to either side, with probability `alpha`.
[[nodiscard]] double t_for(double alpha, int degrees_of_freedom);

}  // namespace bench
