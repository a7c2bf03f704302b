// The photons of one block, from emission to the end of their paths.
#pragma once

#include "common/tracer/hit_batch.h"
#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"

namespace common {

/// Photons traced together; the unit that a run is made of.
inline constexpr std::uint64_t photons_per_block = 256;

/// A photon that has met this many surfaces is given up, so that a room of perfect mirrors ends.
inline constexpr std::uint32_t max_events = 4096;

/// How the photons of a block, or of a run, ended. Every emitted photon is in exactly one of the last four.
struct PhotonFates {
    std::uint64_t emitted = 0;
    std::uint64_t missed = 0;   ///< met no surface at all
    std::uint64_t escaped = 0;  ///< left the scene after meeting a surface
    std::uint64_t absorbed = 0;
    std::uint64_t given_up = 0;  ///< at max_events

    PhotonFates& operator+=(const PhotonFates& other);
};

/// Traces `count` photons, numbers `first_photon` and on, of the run with this seed. `hits` is emptied and
/// filled in, ordered by event number and then by photon.
PhotonFates trace_block(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                        std::uint64_t first_photon, std::uint64_t count, HitBatch& hits);

}  // namespace common
