// The irradiance at the points by path tracing, against which every candidate's bias is measured.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/experiments/fit/fit_points.h"
#include "bench/experiments/fit/halves.h"
#include "bench/experiments/fit/stop.h"
#include "common/reference/reference_pass.h"
#include "common/tracer/photon_source.h"

namespace bench::fit {

/// Two independent estimates of the irradiance at each point by path tracing, W/m^2. They are unbiased: as
/// they have no radius, texel or basis, no kind of map is judged by the errors of another. Their noise adds
/// only variance, since each half is independent of the other, of all photons, and of a reference made with
/// the same seed.
class PathTruth {
  public:
    /// Keeps references to all arguments, which must outlive it.
    PathTruth(const LoadedScene& loaded, const common::PhotonSource& source, const FitPoints& points,
              std::uint64_t seed);

    /// Names the light that no path finds (common::reference::paths_not_found). If there is any, this is no
    /// truth.
    [[nodiscard]] const std::string& lost_light() const { return lost_light_; }

    /// Returns the samples of each half, averaged over the points.
    [[nodiscard]] static std::uint64_t samples_of(int level);

    /// Returns the estimates of a level, tracing those levels that are missing. Level 0 has 64 samples, and
    /// each further level has twice as many as the one before. Throws Stopped.
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
