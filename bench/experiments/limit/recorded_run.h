// The rays of a run, kept in the order in which a tracer without waves would ask for them.
#pragma once

#include <functional>
#include <vector>

#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"
#include "common/tracer/trace_report.h"

namespace bench::limit {

/// Rays that are replayed together: as many as the tracer has photons in a block.
inline constexpr std::size_t rays_per_block = common::photons_per_block;

struct RayBlock {
    common::Vec3Array origin;
    common::Vec3Array direction;  ///< unit, the way the photon travels

    [[nodiscard]] std::size_t size() const { return origin.x.size(); }

    /// What is new has no defined value.
    void resize(std::size_t rays) {
        origin.resize(rays);
        direction.resize(rays);
    }
};

struct RecordedRun {
    std::vector<RayBlock> blocks;  ///< all full but the last
    std::uint64_t rays = 0;        ///< in all blocks
    common::TraceReport report;    ///< what a trace of the same photons must say too, without times

    void add(const common::Vec3& origin, const common::Vec3& direction);
};

/// Called after each 4096 photons with what is done so far; returns false to end the recording there.
using RecordProgress = std::function<bool(const RecordedRun& so_far)>;

/// Follows the photons 0, 1, ... of the run with this seed, one after the other and each from its light to
/// its end, until there are `hits` hits: the photons that trace_photons traces for that target, and every ray
/// that it traces for them, also those that meet nothing, a mirror or glass. Path by path, each begins
/// where the one before has met the scene; sorting makes single rays faster or slower by up to 3 %.
///
/// Throws InputError where the rays take more than `max_bytes`, or where so many photons have met nothing
/// that the hits will not be reached.
[[nodiscard]] RecordedRun record_run(const common::RayScene& rays, const common::PhotonSource& source,
                                     std::uint64_t seed, std::uint64_t hits, std::size_t max_bytes,
                                     const RecordProgress& progress);

/// The same rays, those of each block in PhotonOrder: how the tracer asks Embree.
[[nodiscard]] std::vector<RayBlock> sorted_blocks(const std::vector<RayBlock>& blocks,
                                                  const Imath::Box3f& bounds);

}  // namespace bench::limit
