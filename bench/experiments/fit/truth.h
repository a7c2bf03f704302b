// The light at the points as paths find it: what every candidate's bias is measured against.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/experiments/fit/fit_points.h"
#include "bench/experiments/fit/halves.h"
#include "bench/experiments/fit/stop.h"
#include "common/reference/reference_pass.h"
#include "common/tracer/photon_source.h"

namespace bench::fit {

/// Two independent estimates of the irradiance at each point by path tracing, W/m^2. They have no bias: no
/// radius, texel or basis, so no kind of map is measured by the faults of another. They are noisy, which
/// costs nothing but certainty, as nothing in one half knows of the other, of any photon or of a reference
/// that was made with the same seed.
class PathTruth {
  public:
    /// All must outlive it.
    PathTruth(const LoadedScene& loaded, const common::PhotonSource& source, const FitPoints& points,
              std::uint64_t seed);

    /// What no path finds, in words (common::reference::paths_not_found): then it is no truth.
    [[nodiscard]] const std::string& lost_light() const { return lost_light_; }

    /// Samples of each half, in the mean over the points.
    [[nodiscard]] static std::uint64_t samples_of(int level);

    /// Level 0 has 64 samples, each other one twice as many as the one before. Traces what is not there yet.
    /// Throws Stopped.
    [[nodiscard]] const Halves& at(int level, const StopRule& stop);

  private:
    [[nodiscard]] Halves next_level(const StopRule& stop) const;
    [[nodiscard]] std::vector<common::Rgb> fresh_means(std::span<const std::uint64_t> passes_of_tile,
                                                       std::uint64_t seed, const StopRule& stop) const;
    [[nodiscard]] std::vector<common::Rgb> one_pass(std::span<const common::VisibleSurface> seen,
                                                    std::uint64_t seed, const StopRule& stop) const;

    const LoadedScene& loaded_;
    const FitPoints& points_;
    std::uint64_t seed_;
    int most_surfaces_;
    std::string lost_light_;
    common::reference::Lights lights_;
    std::vector<Halves> level_;
};

}  // namespace bench::fit
