// The target of a run, and its results so far.
#pragma once

#include <cstdint>
#include <span>

#include "common/tracer/trace_block.h"

namespace common {

/// How the photons of a run ended. Every emitted photon is in exactly one of the last five.
struct PhotonFates {
    std::uint64_t emitted = 0;
    std::uint64_t missed = 0;
    std::uint64_t escaped = 0;
    std::uint64_t absorbed = 0;
    std::uint64_t given_up = 0;
    std::uint64_t without_light = 0;

    void add(std::span<const PhotonFate> photons);
    PhotonFates& operator+=(const PhotonFates& other);
};

struct TraceReport {
    PhotonFates fates;
    std::uint64_t hits = 0;
    double trace_seconds = 0;  ///< wall time outside the sink
    double sink_seconds = 0;   ///< wall time inside the sink
    bool interrupted = false;

    /// Returns the factor from HitBatch::flux to W, the only place that divides by the number of photons.
    [[nodiscard]] float watts_per_flux() const {
        return fates.emitted == 0 ? 0.0f : static_cast<float>(1.0 / static_cast<double>(fates.emitted));
    }
};

/// The length of a run: it ends with the photon that reaches both numbers.
struct TraceTarget {
    std::uint64_t photons = 0;  ///< emitted, at least
    std::uint64_t hits = 0;     ///< at least
    std::uint64_t first_photon = 0;

    [[nodiscard]] bool reached_by(const TraceReport& report) const {
        return missing_photons(report) == 0 && missing_hits(report) == 0;
    }
    [[nodiscard]] std::uint64_t missing_photons(const TraceReport& so_far) const {
        return photons > so_far.fates.emitted ? photons - so_far.fates.emitted : 0;
    }
    [[nodiscard]] std::uint64_t missing_hits(const TraceReport& so_far) const {
        return hits > so_far.hits ? hits - so_far.hits : 0;
    }
    /// Returns the number of the next photon.
    [[nodiscard]] std::uint64_t next_photon(const TraceReport& so_far) const {
        return first_photon + so_far.fates.emitted;
    }
};

/// Throws InputError if so many photons have hit nothing that the target will not be reached.
void check_that_photons_hit(const TraceReport& so_far, const TraceTarget& target);

}  // namespace common
