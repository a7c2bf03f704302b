// Traces recorded rays through Embree and does nothing else.
#pragma once

#include <cstdint>
#include <span>

#include "bench/experiments/limit/recorded_run.h"

namespace bench::limit {

/// Find the nearest surface along every ray, block by block on the threads of the calling arena, and keep the
/// results until the next block. Rays are traced one by one, or in RayScene's packets of neighbours.
void replay_single(const common::RayScene& rays, std::span<const RayBlock> blocks);
void replay_packets(const common::RayScene& rays, std::span<const RayBlock> blocks);

/// Returns the number of rays whose surface in packets differs in any bit from that found alone. It should be
/// 0.
[[nodiscard]] std::uint64_t count_differences(const common::RayScene& rays, std::span<const RayBlock> blocks);

}  // namespace bench::limit
