// Compares maps bit by bit after everything was scaled by a power of two.
#pragma once

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {

/// Answers of both methods to the same queries; one list for each entry of `answering`.
using BoxAnswers = std::array<std::vector<float>, 4>;
inline constexpr std::array answering = {"photon map, flann", "photon map, compact", "light map, own texel",
                                         "light map, 4 nearest texels"};

/// Evaluates maps of these hits at 16 points on each wall of a box made of quads, and multiplies the answers
/// by `factor`. `max_radius`, in scene units, limits gathers of 50 photons.
[[nodiscard]] BoxAnswers answers_in_box(const common::Scene& box, const shlm::PreparedTexels& texels,
                                        const common::HitBatch& hits, double max_radius, float factor,
                                        Generator generator);

/// Returns one curve per entry of `answering`, with the prediction 0.
[[nodiscard]] std::vector<StabilityCurve> curves_of_differences(std::span<const double> places,
                                                                const std::string& suffix, Expected expected);

/// Adds to each curve, at one point, the fraction of the answers that differ.
void measure_differences(std::span<StabilityCurve> curves, std::size_t point, const BoxAnswers& a,
                         const BoxAnswers& b);

}  // namespace bench::stability
