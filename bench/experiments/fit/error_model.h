// Models a candidate's squared error as a function of its hits, and solves for the hits that a target needs.
#pragma once

#include <cmath>
#include <optional>

namespace bench::fit {

/// Squared relative errors, averaged over points and channels.
struct ErrorModel {
    double pilot_hits = 0;         ///< of one half
    double noise_sq = 0;           ///< variance of one half
    double blur_sq = 0;            ///< squared bias that does not fall with more hits
    double truncation_sq = 0;      ///< likewise, the squared bias of the basis; light maps only
    double bias_variance = 0;      ///< variance over pilots of the estimate of blur_sq + truncation_sq
    double sampling_variance = 0;  ///< variance of the same over other points of the image (SquareEstimate)
    double spread_variance = 0;    ///< variance_about the best answers, of the candidate's own halves
    double noise_variance = 0;     ///< bound on Var(mean square noise of one half) (most_noise_variance)
    bool at_pilot_alone = false;   ///< the error is known for pilot_hits only

    [[nodiscard]] double bias_sq() const { return blur_sq + truncation_sq; }

    /// Return bounds of the squared bias, z standard errors away. The lower one may be negative.
    [[nodiscard]] double upper_bias_sq(double z) const { return bias_sq() + z * bias_deviation(); }
    [[nodiscard]] double lower_bias_sq(double z) const { return bias_sq() - z * bias_deviation(); }
    [[nodiscard]] double bias_deviation() const { return std::sqrt(bias_variance + sampling_variance); }

    /// Returns the expected squared error of a run with so many hits.
    [[nodiscard]] double error_sq(double hits) const { return bias_sq() + noise_sq * pilot_hits / hits; }

    /// Returns the standard deviation of the difference between the squared error of one run with so many
    /// hits and the error_sq that one pilot predicts for it. The part sampling_variance remains however many
    /// hits the pilot has.
    ///
    /// Let x = pilot_hits / hits, beta the bias, and alpha and alpha' the noise of the halves, normally
    /// distributed. Three terms contribute. The estimate of the bias has w alpha alpha'. The estimate of the
    /// noise has x w (alpha - alpha')^2 / 2. The run itself has w (2 sqrt(x) beta alpha + x alpha^2). Let V
    /// be Var(mean w beta alpha) and N be Var(mean w alpha^2). Then the estimate of the noise has variance
    /// x^2 N and covariance -x N / 2 with that of the bias, and the run has variance 4 x V + x^2 N. As
    /// spread_variance is 2 V + N / 2, the sum beside bias_variance is 2 x spread_variance + 2 (x^2 - x) N.
    [[nodiscard]] double deviation(double hits) const;

    /// Returns the standard error of error_sq as an estimate of the mean over runs at the same points. Its
    /// square is bias_variance + max(0, x^2 - x) N.
    [[nodiscard]] double doubt(double hits) const;
};

/// Returns the fewest hits for which error_sq + z deviation is at most the target's square. A run then meets
/// the target with the probability that a standard normal variable is below z. None where no number of hits
/// suffices, or where only the pilot's hits are known and do not suffice.
[[nodiscard]] std::optional<double> hits_for(const ErrorModel& model, double target, double z);

}  // namespace bench::fit
