// The run and the photons that a light map's sums come from.
#pragma once

#include <array>
#include <map>
#include <string>

#include "common/tracer/rejected_hits.h"
#include "common/tracer/trace_photons.h"
#include "shlm/sums/clamped_light.h"

namespace shlm {

/// What must be the same for sums to be added. Two runs that agree in this have the same texels, quanta and
/// photons.
struct MapIdentity {
    std::string scene;          ///< common::fingerprint
    std::string model;          ///< order and weight, as in a method's name
    std::string texels_wanted;  ///< how many, and their placement, as in --texels
    std::uint64_t texels = 0;
    std::uint64_t numbers = 0;     ///< summed per texel and channel
    std::array<int, 3> quantum{};  ///< Quantum::exponents
    std::uint64_t seed = 0;

    /// Describes the difference, such as "it has seed 2, not 1"; empty if there is none. `found` is the
    /// other's.
    [[nodiscard]] std::string difference(const MapIdentity& found) const;
};

/// Photons first_photon to end_photon() - 1, and their fates.
struct MapRun {
    MapIdentity identity;
    std::uint64_t first_photon = 0;
    common::PhotonFates fates;
    std::uint64_t hits = 0;
    common::RejectedHits rejected;  ///< before hits on uncovered texels are counted
    ClampedLight clamped;
    std::string program;  ///< version that wrote it

    [[nodiscard]] std::uint64_t end_photon() const { return first_photon + fates.emitted; }

    /// Returns the trace so far, for trace_photons() to continue.
    [[nodiscard]] common::TraceReport report() const;

    /// Adds the counts of a run that begins where this one ends.
    void append(const MapRun& next);
};

/// Converts to text attributes of a file's header, shlmbench:KEY, and back. Throws InputError if one is
/// missing or not a number.
[[nodiscard]] std::map<std::string, std::string> to_notes(const MapRun& run);
[[nodiscard]] MapRun map_run_of(const std::map<std::string, std::string>& notes);

}  // namespace shlm
