// Recorded rays through Embree and nothing else.
#pragma once

#include <cstdint>
#include <span>

#include "bench/experiments/limit/recorded_run.h"

namespace bench::limit {

/// Both find the nearest surface along every ray, block by block on the threads of the calling arena, and
/// keep it until the next block: one by one, or in RayScene's packets of neighbours.
void replay_single(const common::RayScene& rays, std::span<const RayBlock> blocks);
void replay_packets(const common::RayScene& rays, std::span<const RayBlock> blocks);

/// How many rays find another surface in packets than alone, to the last bit: should be 0.
[[nodiscard]] std::uint64_t count_differences(const common::RayScene& rays, std::span<const RayBlock> blocks);

}  // namespace bench::limit
