// Whether maps answer the same to the bit after everything was scaled by a power of two.
#pragma once

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {

/// BoxAnswers of both methods to the same questions.
using BoxAnswers = std::array<std::vector<float>, 4>;
inline constexpr std::array answering = {"photon map, flann", "photon map, compact", "light map, own texel",
                                         "light map, 4 nearest texels"};

/// Asks maps of these hits, in a box made of quads, at 16 places on each wall; multiplies what they say by
/// `factor`. `max_radius`, world units, is that of gathers of 50 photons.
[[nodiscard]] BoxAnswers answers_in_box(const common::Scene& box, const shlm::PreparedTexels& texels,
                                        const common::HitBatch& hits, double max_radius, float factor,
                                        Generator generator);

/// A curve for each way of answering, with 0 predicted.
[[nodiscard]] std::vector<StabilityCurve> curves_of_differences(std::span<const double> places,
                                                                const std::string& suffix, Expected expected);

/// Part of the answers that are not the same, for each way of answering, at one point of its curve.
void measure_differences(std::span<StabilityCurve> curves, std::size_t point, const BoxAnswers& a,
                         const BoxAnswers& b);

}  // namespace bench::stability
