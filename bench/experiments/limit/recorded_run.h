// Records the rays of a run, in the order in which a tracer without waves would trace them.
#pragma once

#include <functional>
#include <vector>

#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"
#include "common/tracer/trace_report.h"

namespace bench::limit {

/// Number of rays that are replayed together: the tracer's photons per block.
inline constexpr std::size_t rays_per_block = common::photons_per_block;

struct RayBlock {
    common::Vec3Array origin;
    common::Vec3Array direction;  ///< unit, along the photon's travel

    [[nodiscard]] std::size_t size() const { return origin.x.size(); }

    /// New elements are uninitialised.
    void resize(std::size_t rays) {
        origin.resize(rays);
        direction.resize(rays);
    }
};

struct RecordedRun {
    std::vector<RayBlock> blocks;  ///< all full but the last
    std::uint64_t rays = 0;        ///< in all blocks
    common::TraceReport report;    ///< which a trace of the same photons must reproduce, except for times

    void add(const common::Vec3& origin, const common::Vec3& direction);
};

/// Called every 4096 photons with the state so far. Returns false to end the recording.
using RecordProgress = std::function<bool(const RecordedRun& so_far)>;

/// Follows photons 0, 1, ... of the run with this seed, each from its light to its end, until there are
/// `hits` hits. These are the photons that trace_photons traces for that target. All their rays are recorded,
/// also those that hit nothing, a mirror or glass. The order is path by path, so each ray begins where the
/// one before hit the scene. Sorting makes single rays faster or slower by up to 3 %.
///
/// Throws InputError where the rays take more than `max_bytes`, or where so many photons have hit nothing
/// that the target cannot be reached.
[[nodiscard]] RecordedRun record_run(const common::RayScene& rays, const common::PhotonSource& source,
                                     std::uint64_t seed, std::uint64_t hits, std::size_t max_bytes,
                                     const RecordProgress& progress);

/// Returns the same rays with each block sorted in PhotonOrder, as the tracer passes them to Embree.
[[nodiscard]] std::vector<RayBlock> sorted_blocks(const std::vector<RayBlock>& blocks,
                                                  const Imath::Box3f& bounds);

}  // namespace bench::limit
