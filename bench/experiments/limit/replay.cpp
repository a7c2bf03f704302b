#include "bench/experiments/limit/replay.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <bit>

#include "common/core/interrupt.h"

namespace bench::limit {
namespace {

using common::NearestSurfaces;
using common::SurfaceId;

/// Calls `work` with every block and the calling thread's buffer for the results. Skips the remaining blocks
/// once the user interrupts.
template <class Work>
void for_each_block(std::span<const RayBlock> blocks, const Work& work) {
    tbb::enumerable_thread_specific<NearestSurfaces> found;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, blocks.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end() && !common::interrupted(); ++i)
                work(blocks[i], found.local());
        },
        tbb::simple_partitioner());
}

SurfaceId nearest_alone(const common::RayScene& rays, const RayBlock& block, std::size_t i) {
    return rays.nearest(block.origin[i], block.direction[i]).value_or(common::no_surface);
}

/// Compares bit by bit; where nothing is found, u and v are undefined.
bool same(const SurfaceId& a, const SurfaceId& b) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return a.triangle == b.triangle &&
           (a.triangle == common::no_triangle || (bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v)));
}

}  // namespace

void replay_single(const common::RayScene& rays, std::span<const RayBlock> blocks) {
    for_each_block(blocks, [&](const RayBlock& block, NearestSurfaces& found) {
        found.resize(block.size());
        for (std::size_t i = 0; i < block.size(); ++i) found.set(i, nearest_alone(rays, block, i));
    });
}

void replay_packets(const common::RayScene& rays, std::span<const RayBlock> blocks) {
    for_each_block(blocks, [&](const RayBlock& block, NearestSurfaces& found) {
        rays.nearest(block.origin, block.direction, found);
    });
}

std::uint64_t count_differences(const common::RayScene& rays, std::span<const RayBlock> blocks) {
    std::atomic<std::uint64_t> differences = 0;
    for_each_block(blocks, [&](const RayBlock& block, NearestSurfaces& found) {
        rays.nearest(block.origin, block.direction, found);
        for (std::size_t i = 0; i < block.size(); ++i)
            differences += !same(found[i], nearest_alone(rays, block, i));
    });
    return differences;
}

}  // namespace bench::limit
