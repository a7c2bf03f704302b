// The pilot: two independent halves of a run, each asked by every candidate.
#pragma once

#include <span>
#include <vector>

#include "bench/contenders/trace_into.h"
#include "bench/experiments/fit/candidates.h"
#include "bench/experiments/fit/fit_points.h"
#include "bench/experiments/fit/halves.h"
#include "bench/experiments/fit/stop.h"

namespace bench::fit {

/// What a pilot traces. All must outlive it.
struct PilotSubject {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    PreparedScene& prepared;
    const FitPoints& points;
    std::uint64_t seed;
    std::size_t max_bytes;  ///< for all stores that are filled at once
};

/// What one half has cost, wall time of all threads.
struct PilotCost {
    double hits = 0;
    double trace_seconds = 0;
    double insert_seconds = 0;
    double build_seconds = 0;
    double gather_seconds = 0;   ///< all points
    double bytes = 0;            ///< of the finished map
    double prepare_seconds = 0;  ///< once for the scene
};

/// What is known of a candidate: nothing before its first pilot.
struct PilotSample {
    Halves halves;
    PilotCost cost;  ///< the mean of both halves
    [[nodiscard]] bool present() const { return halves.present(); }
};

/// Whether so many hits say anything about the candidate: two hits a texel,
/// least_nearest to most_nearest photons a gather.
[[nodiscard]] bool is_measurable(const Candidate& candidate, std::uint64_t hits);

/// Fills the samples of the chosen candidates anew with `hits` hits a half; those that do not fit into memory
/// stay as they are. Half A is the run's photons from the first on, half B those from 2^40 on: the counters
/// of the random numbers (common/core/random.h) have no photon in common, and no run comes so far. Photons of
/// a smaller pilot are the first of a larger one, in the same half, so that samples of different sizes may be
/// compared: what is in half A of one is never in half B of another. Throws Stopped; then what was not
/// finished is not present.
void run_pilot(const PilotSubject& subject, std::span<const Candidate> candidates,
               std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
               std::vector<PilotSample>& samples);

}  // namespace bench::fit
