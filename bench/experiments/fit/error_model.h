// A candidate's squared error as a function of its hits, and the hits that a target takes.
#pragma once

#include <cmath>
#include <optional>

namespace bench::fit {

/// Relative and squared, mean over points and channels.
struct ErrorModel {
    double pilot_hits = 0;         ///< of one half
    double noise_sq = 0;           ///< variance of one half
    double blur_sq = 0;            ///< does not fall with more hits
    double truncation_sq = 0;      ///< neither does this; light maps only
    double bias_variance = 0;      ///< of the estimate of blur_sq + truncation_sq over pilots
    double sampling_variance = 0;  ///< of the same over other points of the image (SquareEstimate)
    double spread_variance = 0;    ///< variance_about the best answer, of the candidate's own halves
    double noise_variance = 0;     ///< of the mean square noise of one half, at most (most_noise_variance)
    bool at_pilot_alone = false;   ///< nothing is known of other numbers of hits: pilot_hits is all there is

    [[nodiscard]] double bias_sq() const { return blur_sq + truncation_sq; }

    /// Bounds of the bias, z standard errors away. The lower one may be below zero.
    [[nodiscard]] double upper_bias_sq(double z) const { return bias_sq() + z * bias_deviation(); }
    [[nodiscard]] double lower_bias_sq(double z) const { return bias_sq() - z * bias_deviation(); }
    [[nodiscard]] double bias_deviation() const { return std::sqrt(bias_variance + sampling_variance); }

    /// Expected at so many hits.
    [[nodiscard]] double error_sq(double hits) const { return bias_sq() + noise_sq * pilot_hits / hits; }

    /// Standard deviation of (the squared error of one run with so many hits) less (error_sq of one pilot).
    /// Of its variance sampling_variance is a part that stays however many hits the pilot has.
    ///
    /// With x = pilot_hits / hits, beta the bias, alpha and alpha' the noise of the halves, the parts are:
    /// the estimate of the bias, which has w alpha alpha'; x times that of the noise, w (alpha - alpha')^2 /
    /// 2; and the run's own w (2 sqrt(x) beta alpha + x alpha^2). Let V be Var(mean w beta alpha) and N
    /// Var(mean w alpha^2), alpha normal. Then the estimate of the noise has the variance x^2 N, and -x N / 2
    /// is its covariance with that of the bias; the run has 4 x V + x^2 N. As spread_variance is 2 V + N / 2,
    /// that makes 2 x spread_variance + 2 (x^2 - x) N.
    [[nodiscard]] double deviation(double hits) const;

    /// Of error_sq as an estimate of the mean over runs at the same points: bias_variance + (x^2 - x) N,
    /// counted from x = 1 on.
    [[nodiscard]] double doubt(double hits) const;
};

/// The fewest hits with which error_sq + z deviation is at most the target's square: a run then meets the
/// target with the probability of a normal variable to be below z. None where no number of hits does, or the
/// pilot's do not and nothing is known of others.
[[nodiscard]] std::optional<double> hits_for(const ErrorModel& model, double target, double z);

}  // namespace bench::fit
