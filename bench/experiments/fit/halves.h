// Estimates the difference of two estimators and its variance from two independent runs, without knowing the
// truth.
#pragma once

#include <span>
#include <vector>

#include "bench/experiments/fit/tiling.h"
#include "common/core/vector.h"

namespace bench::fit {

/// The answers of one candidate at the points from two independent halves of the photons, W/m^2.
struct Halves {
    std::vector<common::Rgb> a, b;
    [[nodiscard]] bool present() const { return !a.empty() && !b.empty(); }
};

/// The weights of relative errors, and the positions of the points in the image.
struct Measure {
    std::vector<common::Rgb> weight;      ///< of each point: 1 / (R^2 + epsilon), R the best known answer
    std::span<const std::uint32_t> tile;  ///< of each point
    Tiling tiling;

    /// Throws InputError where R is black (relative_epsilon).
    Measure(std::span<const common::Rgb> best, std::span<const std::uint32_t> tile_of,
            const Tiling& tiling_of);
};

/// An estimate of a squared relative error, averaged over points and channels, and its variance.
///
/// The variance follows from exchanging the two halves a and b. Consider a tile's contribution to the mean of
/// w (a - f)^2, minus the same with b. Its expectation is zero, and its spread is due to the photons alone,
/// however the light differs between tiles. Let a - f = beta + alpha and b - f = beta + alpha'. Half that
/// difference is the sum of w (beta + (alpha + alpha') / 2) (alpha - alpha'). Where alpha is normal, its
/// variance is that of the sum of w (a - f)(b - f): beta (alpha - alpha') varies as beta (alpha + alpha'),
/// and (alpha^2 - alpha'^2) / 2 as alpha alpha'. So these differences of the tiles give the variance of the
/// estimate (variance_of_sum).
struct SquareEstimate {
    double value = 0;
    /// Variance of the mean over another set of as many image points, from the contributions of single points
    /// less their noise. The points are a grid, which may hit narrow creases or miss them.
    double sampling_variance = 0;
    std::vector<double> tile_difference;  ///< half the difference between the halves, of each tile
    Tiling tiling;

    [[nodiscard]] double variance() const;
};

/// Estimates the squared difference of what `halves` and `other` converge to: the mean of w (a - f_a)(b -
/// f_b). It is unbiased, since the a's are independent of the b's. It may be negative.
[[nodiscard]] SquareEstimate squared_difference(const Halves& halves, const Halves& other,
                                                const Measure& measure);

/// Returns the mean of w (value)^2 over the points.
[[nodiscard]] double mean_square(std::span<const common::Rgb> values, const Measure& measure);

/// Estimates the variance of one half: the mean of w (a - b)^2 / 2.
[[nodiscard]] double noise_sq(const Halves& halves, const Measure& measure);

/// Bounds the variance over runs of the mean square noise of one half. The bound is the sum of the squares of
/// the tiles' contributions, as a variance is at most the mean square. Where noise is correlated between
/// tiles, it is scaled by the factor by which this raises the variance of the noise itself.
[[nodiscard]] double most_noise_variance(const Halves& halves, const Measure& measure);

/// Returns the variance over runs, due to the photons of `halves` alone, of half the difference between the
/// halves' squared distances to `centre`. This is SquareEstimate's variance where `other` has none.
[[nodiscard]] double variance_about(const Halves& halves, std::span<const common::Rgb> centre,
                                    const Measure& measure);

/// Combines the answers with `truth`, which is unbiased, into the mean of least error, tile by tile: the
/// weight of each is proportional to the squared error of the other. The answers alone would blur the light
/// where the candidate does, and an error relative to them would count too little.
[[nodiscard]] std::vector<common::Rgb> joined(const Halves& answers, const Halves& truth,
                                              const Measure& measure);

/// Returns the mean of both halves.
[[nodiscard]] std::vector<common::Rgb> mean_of(const Halves& halves);

}  // namespace bench::fit
