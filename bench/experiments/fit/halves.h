// How far an estimator is from another, and how much it varies, from two runs of it and without a truth.
#pragma once

#include <span>
#include <vector>

#include "bench/experiments/fit/tiling.h"
#include "common/core/vector.h"

namespace bench::fit {

/// What one candidate answers at the points by two independent halves of the photons, W/m^2.
struct Halves {
    std::vector<common::Rgb> a, b;
    [[nodiscard]] bool present() const { return !a.empty() && !b.empty(); }
};

/// What a relative error is relative to, and where points stand in the image.
struct Measure {
    std::vector<common::Rgb> weight;      ///< of each point: 1 / (R^2 + epsilon), R the best answer there is
    std::span<const std::uint32_t> tile;  ///< of each point
    Tiling tiling;

    /// Throws InputError where R is black (relative_epsilon).
    Measure(std::span<const common::Rgb> best, std::span<const std::uint32_t> tile_of,
            const Tiling& tiling_of);
};

/// A squared relative error, mean over points and channels, with what tells how sure it is.
///
/// The two halves may be exchanged: what a tile adds to mean w (a - f)^2 less what it adds to the same with b
/// is zero in the mean over all photons, and its spread is the photons' alone, whatever the light is like in
/// different tiles. With a - f = beta + alpha and b - f = beta + alpha', half that difference is the sum of
/// w (beta + (alpha + alpha') / 2) (alpha - alpha'), whose variance is that of the sum of w (a - f)(b - f)
/// where alpha is normal: beta (alpha - alpha') varies as beta (alpha + alpha'), and (alpha^2 - alpha'^2) / 2
/// as alpha alpha'. So the tiles say what the variance of the estimate is (variance_of_sum).
struct SquareEstimate {
    double value = 0;
    /// Of the mean over other points of the image as many: from how much single points add, without what
    /// noise makes of that. The points are a grid, and it hits narrow creases or misses them.
    double sampling_variance = 0;
    std::vector<double> tile_difference;  ///< half the difference between the halves, of each tile
    Tiling tiling;

    [[nodiscard]] double variance() const;
};

/// (What `halves` converges to - what `other` converges to)^2: mean of w (a - f_a)(b - f_b), without bias as
/// nothing of a is in b. May come out below zero.
[[nodiscard]] SquareEstimate squared_difference(const Halves& halves, const Halves& other,
                                                const Measure& measure);

/// Of something that has a value at each point: mean of w (value)^2.
[[nodiscard]] double mean_square(std::span<const common::Rgb> values, const Measure& measure);

/// Variance of one half: mean of w (a - b)^2 / 2.
[[nodiscard]] double noise_sq(const Halves& halves, const Measure& measure);

/// Variance over runs of the mean square noise of one half, at most: the sum of the squares of what the tiles
/// add, as a variance is at most the mean square; more where noise joins tiles, by as much as that adds to
/// the variance of the noise itself.
[[nodiscard]] double most_noise_variance(const Halves& halves, const Measure& measure);

/// Variance over runs, as far as the photons of `halves` alone cause it, of half the difference between the
/// halves' squared distances to `centre`: what SquareEstimate's variance is where the other does not vary.
[[nodiscard]] double variance_about(const Halves& halves, std::span<const common::Rgb> centre,
                                    const Measure& measure);

/// Of the answers and of what `truth` has no bias of, the mean with the least error, tile by tile: each
/// counts as the other errs there. By the answers alone light would be blurred where theirs is, and an error
/// relative to it would count too little.
[[nodiscard]] std::vector<common::Rgb> joined(const Halves& answers, const Halves& truth,
                                              const Measure& measure);

/// Mean of both halves.
[[nodiscard]] std::vector<common::Rgb> mean_of(const Halves& halves);

}  // namespace bench::fit
