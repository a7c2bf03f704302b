// Whether what was measured is what theory says.
#pragma once

#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {

/// Chance that a sound program fails any point of any case by accident, for all cases together.
inline constexpr double family_false_alarms = 1e-3;

struct PointVerdict {
    double mean;
    double confidence;  ///< half width of the 95 % interval of the mean; 0 for a single value
    double band;        ///< half width of what passes around the prediction: what is allowed, and chance
    bool judged;
    bool passed;  ///< also where it is not judged
};

/// Chance of failing each judged point of a case, that of all points of all `cases` being
/// family_false_alarms (Bonferroni).
[[nodiscard]] double false_alarms_per_point(std::span<const StabilityCurve> curves, std::size_t cases);

/// `false_alarms`: for this point, by Student's t over the seeds. A value that is not finite never passes.
[[nodiscard]] PointVerdict judge(const StabilityPoint& point, Expected expected, double false_alarms);

/// Whether all judged points pass, and there is one.
[[nodiscard]] bool passes(std::span<const StabilityCurve> curves, std::size_t cases);

}  // namespace bench::stability
