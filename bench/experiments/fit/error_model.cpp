#include "bench/experiments/fit/error_model.h"

#include <algorithm>
#include <cmath>

namespace bench::fit {

namespace {

/// Returns max(0, x^2 - x) N.
double noise_doubt(const ErrorModel& model, double x) {
    const double noise_alone = std::min(model.noise_variance, 2 * model.spread_variance);
    return std::max(0.0, x * x - x) * noise_alone;
}

}  // namespace

double ErrorModel::deviation(double hits) const {
    const double x = pilot_hits / hits;
    return std::sqrt(bias_variance + sampling_variance + 2 * x * spread_variance + 2 * noise_doubt(*this, x));
}

double ErrorModel::doubt(double hits) const {
    return std::sqrt(bias_variance + noise_doubt(*this, pilot_hits / hits));
}

std::optional<double> hits_for(const ErrorModel& model, double target, double z) {
    constexpr double fewest = 1, most = 1e18;
    const auto meets = [&](double hits) {
        return model.error_sq(hits) + z * model.deviation(hits) <= target * target;
    };
    if (model.at_pilot_alone) return meets(model.pilot_hits) ? std::optional(model.pilot_hits) : std::nullopt;
    if (!meets(most)) return std::nullopt;
    if (meets(fewest)) return fewest;
    // Bisection is possible, as both parts fall with more hits.
    double low = std::log(fewest), high = std::log(most);
    for (int step = 0; step < 100; ++step) {
        const double middle = 0.5 * (low + high);
        (meets(std::exp(middle)) ? high : low) = middle;
    }
    return std::exp(high);
}

}  // namespace bench::fit
