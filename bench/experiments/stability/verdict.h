// Judges whether measurements agree with theory.
#pragma once

#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {

/// Probability that a correct program fails any point of any case by chance, for all cases together.
inline constexpr double family_false_alarms = 1e-3;

struct PointVerdict {
    double mean;
    double confidence;  ///< half width of the 95 % interval of the mean; 0 for a single value
    double band;        ///< half width of what passes around the prediction: `allowed` plus chance
    bool judged;
    bool passed;  ///< also true where it is not judged
};

/// Returns the probability of a false alarm for each judged point of a case, such that all points of all
/// `cases` together have family_false_alarms (Bonferroni).
[[nodiscard]] double false_alarms_per_point(std::span<const StabilityCurve> curves, std::size_t cases);

/// Judges a point by Student's t over the seeds, with the probability `false_alarms` for this point. A value
/// that is not finite never passes.
[[nodiscard]] PointVerdict judge(const StabilityPoint& point, Expected expected, double false_alarms);

/// Returns whether all judged points pass, and there is at least one.
[[nodiscard]] bool passes(std::span<const StabilityCurve> curves, std::size_t cases);

}  // namespace bench::stability
