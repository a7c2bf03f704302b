#include "bench/experiments/stability/verdict.h"

#include <algorithm>

#include "bench/setup/significance.h"

namespace bench::stability {
namespace {

double mean_of(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double standard_error_of(std::span<const double> values, double mean) {
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const auto count = static_cast<double>(values.size());
    return values.size() < 2 ? 0 : std::sqrt(squares / (count - 1) / count);
}

std::size_t judged_points(std::span<const StabilityCurve> curves) {
    std::size_t points = 0;
    for (const StabilityCurve& curve : curves)
        if (curve.expected != Expected::shown) points += curve.points.size();
    return points;
}

}  // namespace

double false_alarms_per_point(std::span<const StabilityCurve> curves, std::size_t cases) {
    const std::size_t points = std::max<std::size_t>(1, judged_points(curves));
    return family_false_alarms / static_cast<double>(std::max<std::size_t>(1, cases) * points);
}

PointVerdict judge(const StabilityPoint& point, Expected expected, double false_alarms) {
    const double mean = mean_of(point.measured), error = standard_error_of(point.measured, mean);
    const int freedom = static_cast<int>(point.measured.size()) - 1;
    const bool random = freedom > 0 && error > 0;
    PointVerdict verdict{.mean = mean,
                         .confidence = random ? t_for(0.05, freedom) * error : 0,
                         .band = point.allowed + (random ? t_for(false_alarms, freedom) * error : 0),
                         .judged = expected != Expected::shown,
                         .passed = true};
    const double above = mean - point.predicted;
    if (expected == Expected::equal) verdict.passed = std::abs(above) <= verdict.band;
    if (expected == Expected::at_most) verdict.passed = above <= verdict.band;
    return verdict;
}

bool passes(std::span<const StabilityCurve> curves, std::size_t cases) {
    const double false_alarms = false_alarms_per_point(curves, cases);
    for (const StabilityCurve& curve : curves)
        for (const StabilityPoint& point : curve.points)
            if (!judge(point, curve.expected, false_alarms).passed) return false;
    return judged_points(curves) > 0;
}

}  // namespace bench::stability
