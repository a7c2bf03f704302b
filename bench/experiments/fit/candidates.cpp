#include "bench/experiments/fit/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bench::fit {
namespace {

// --- the list: one line here adds a basis, gather or kernel

const std::vector<std::string> bases = {"F0/flux",       "AD/radiance", "F1/radiance",
                                        "YF2/radiance",  "F2/radiance", "L2/radiance",
                                        "L2/normalised", "L4/radiance", "L4/normalised"};
const std::vector<std::string> gathers = {"own", "bilinear", "bilinear/face", "surface4", "surface8"};
const std::vector<std::string> adaptive_gathers = {"bilinear", "bilinear/face"};
const std::vector<std::string> kernels = {"disc", "epanechnikov", "cone"};
constexpr double fewest_texels = 1024, most_texels = 4194304;
const std::vector<double> adaptive_percents = {0.7, 1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32};
const std::vector<double> adaptive_texels = {16384, 65536, 262144, 1048576};
constexpr double largest_radius = 0.05, smallest_radius = 0.00025;  // scene diagonals
constexpr int radii = 25;
constexpr double largest_share = 16384e-6, smallest_share = 16384e-6 / (1 << 20);
constexpr std::uint64_t smallest_grid_k = 8, largest_grid_k = 65536;

double radius(int step) {
    const double exact = largest_radius * std::pow(smallest_radius / largest_radius, step / (radii - 1.0));
    const double digit = std::pow(10, std::floor(std::log10(exact)) - 2);
    return std::round(exact / digit) * digit;
}

}  // namespace

std::uint64_t nearest_count(double share, std::uint64_t hits) {
    return std::max<std::uint64_t>(
        2, static_cast<std::uint64_t>(std::llround(share * static_cast<double>(hits))));
}

std::string Candidate::name(std::uint64_t hits) const {
    switch (kind) {
        case CandidateKind::light_map:
            return fmt::format("shlm/{}/{}/t{:.0f}/h0/half", basis, gather, value);
        case CandidateKind::adaptive_map:
            return fmt::format("shlm/a{:g}/normalised/{}/t{:.0f}", value, gather, texels);
        case CandidateKind::photon_radius:
            return fmt::format("photonmap/compact/r{:.6g}/{}", value, basis);
        case CandidateKind::photon_share:
            break;
    }
    return fmt::format("photonmap/compact/k{}/{}", nearest_count(value, hits), basis);
}

std::string Candidate::chain() const {
    if (is_adaptive()) return name(0);
    return fmt::format("{}/{}/{}", is_light_map() ? "shlm" : "photonmap", basis, gather);
}

double Candidate::width() const {
    switch (kind) {
        case CandidateKind::light_map:
            return 1 / std::sqrt(value);
        case CandidateKind::photon_radius:
            return value;
        case CandidateKind::adaptive_map:
            return 0;
        case CandidateKind::photon_share:
            break;
    }
    return std::sqrt(value);
}

const std::string& finest_basis() {
    static const std::string name = "L4/radiance";
    return name;
}

const std::string& basis_below_finest() {
    static const std::string name = "L2/radiance";
    return name;
}

std::vector<Candidate> all_candidates() {
    std::vector<Candidate> all;
    for (const std::string& basis : bases)
        for (const std::string& gather : gathers)
            for (double texels = fewest_texels; texels <= most_texels; texels *= 4)
                all.push_back({CandidateKind::light_map, basis, gather, texels});
    for (const std::string& gather : adaptive_gathers)
        for (const double texels : adaptive_texels)
            for (const double percent : adaptive_percents)
                all.push_back({CandidateKind::adaptive_map, "adaptive", gather, percent, texels});
    for (const std::string& kernel : kernels) {
        for (int step = 0; step < radii; ++step)
            all.push_back({CandidateKind::photon_radius, kernel, "r", radius(step)});
        for (double share = largest_share; share >= smallest_share; share /= 2)
            all.push_back({CandidateKind::photon_share, kernel, "k", share});
    }
    return all;
}

std::vector<std::string> grid_names() {
    std::vector<std::string> names;
    for (const Candidate& candidate : all_candidates())
        if (candidate.kind != CandidateKind::photon_share) names.push_back(candidate.name(1));
    for (const std::string& kernel : kernels)
        for (std::uint64_t k = smallest_grid_k; k <= largest_grid_k; k *= 2)
            names.push_back(fmt::format("photonmap/compact/k{}/{}", k, kernel));
    return names;
}

}  // namespace bench::fit
