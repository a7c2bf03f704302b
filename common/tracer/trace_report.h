// What a run is asked for, and what has become of it.
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

    /// What turns HitBatch::flux into W. The only place where the number of emitted photons is divided by.
    [[nodiscard]] float watts_per_flux() const {
        return fates.emitted == 0 ? 0.0f : static_cast<float>(1.0 / static_cast<double>(fates.emitted));
    }
};

/// When a run is long enough: with the photon that reaches both.
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
    /// The photon that comes next.
    [[nodiscard]] std::uint64_t next_photon(const TraceReport& so_far) const {
        return first_photon + so_far.fates.emitted;
    }
};

/// Throws InputError where so many photons have met nothing that the target will not be reached.
void check_that_photons_hit(const TraceReport& so_far, const TraceTarget& target);

}  // namespace common
