// The pilot: two independent halves of a run, each of which every candidate is built from.
#pragma once

#include <span>
#include <vector>

#include "bench/contenders/trace_into.h"
#include "bench/experiments/fit/candidates.h"
#include "bench/experiments/fit/fit_points.h"
#include "bench/experiments/fit/halves.h"
#include "bench/experiments/fit/stop.h"

namespace bench::fit {

/// What a pilot traces. Whatever it refers to must outlive it.
struct PilotSubject {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    PreparedScene& prepared;
    const FitPoints& points;
    std::uint64_t seed;
    std::size_t max_bytes;  ///< for all stores that are filled by one trace
};

/// The cost of one half. Times are wall time of all threads.
struct PilotCost {
    double hits = 0;
    double trace_seconds = 0;
    double insert_seconds = 0;
    double build_seconds = 0;    ///< making room for an empty store, and finishing it
    double gather_seconds = 0;   ///< for all points
    double bytes = 0;            ///< of the finished map
    double prepare_seconds = 0;  ///< once for the scene
};

/// The measurements of one candidate; empty before its first pilot.
struct PilotSample {
    Halves halves;
    PilotCost cost;  ///< the mean of both halves
    [[nodiscard]] bool present() const { return halves.present(); }
};

/// Returns whether so many hits can measure the candidate. It takes two hits per texel, or between
/// least_nearest and most_nearest photons per gather.
[[nodiscard]] bool is_measurable(const Candidate& candidate, std::uint64_t hits);

/// Replaces the samples of the chosen candidates by new ones with `hits` hits per half. Candidates that do
/// not fit into memory keep theirs. Half A takes the photons from the first on, half B those from 2^40 on,
/// which no run reaches. The counters of the random numbers (common/core/random.h) thus have no photon in
/// common. The photons of a smaller pilot are the first of a larger one in the same half. So samples of
/// different sizes may be compared: half A of one never has a photon of half B of another. Throws Stopped;
/// what was not finished is then not present.
void run_pilot(const PilotSubject& subject, std::span<const Candidate> candidates,
               std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
               std::vector<PilotSample>& samples);

}  // namespace bench::fit
