#include "bench/experiments/bases/basis_error.h"

#include <algorithm>
#include <numeric>

#include "bench/experiments/bases/directions.h"

namespace bench::bases {

std::vector<common::Vec3> tilted_normals() {
    constexpr double cosine_of_60_degrees = 0.5;
    return directions_in_cap(300, cosine_of_60_degrees);
}

std::vector<double> true_irradiance(std::span<const Arrival> arrivals,
                                    std::span<const common::Vec3> normals) {
    std::vector<double> irradiance;
    for (const common::Vec3& normal : normals) {
        double sum = 0;
        for (const Arrival& arrival : arrivals)
            sum += std::max(0.0f, normal.dot(arrival.towards_light)) * arrival.irradiance * arrival.tint.x /
                   arrival.towards_light.z;
        irradiance.push_back(sum);
    }
    return irradiance;
}

double relative_rms_percent(std::span<const double> answers, std::span<const double> truth) {
    double squares = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        squares += (answers[i] - truth[i]) * (answers[i] - truth[i]);
    const auto count = static_cast<double>(truth.size());
    const double mean = std::accumulate(truth.begin(), truth.end(), 0.0) / count;
    return 100 * std::sqrt(squares / count) / mean;
}

}  // namespace bench::bases
