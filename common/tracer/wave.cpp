#include "common/tracer/wave.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace common {
namespace {

double blocks_to_photons(const TraceReport& so_far, const TraceTarget& target) {
    return static_cast<double>(target.missing_photons(so_far)) / photons_per_block;
}

/// Estimates the blocks that are needed, from what has been traced so far.
double blocks_to_hits(const TraceReport& so_far, const TraceTarget& target) {
    // Before anything is known, assumes one hit per photon, and goes a quarter of the way to learn more.
    const double photons_per_hit =
        so_far.hits == 0 ? 0.25
                         : static_cast<double>(so_far.fates.emitted) / static_cast<double>(so_far.hits);
    return static_cast<double>(target.missing_hits(so_far)) * photons_per_hit / photons_per_block;
}

}  // namespace

std::size_t blocks_in_next_wave(const TraceReport& so_far, const TraceTarget& target) {
    const double wanted = std::max(blocks_to_photons(so_far, target), blocks_to_hits(so_far, target));
    return static_cast<std::size_t>(
        std::clamp(std::ceil(wanted), 1.0, static_cast<double>(max_blocks_per_ordered_wave)));
}

std::size_t whole_blocks_ahead(const TraceReport& so_far, const TraceTarget& target) {
    if (target.next_photon(so_far) % photons_per_block != 0) return 0;
    // Photons have different numbers of hits; nine tenths of the estimate are safe.
    const double hits_are_safe = so_far.hits == 0 ? 0 : 0.9 * blocks_to_hits(so_far, target);
    const double safe = std::max(blocks_to_photons(so_far, target), hits_are_safe);
    if (safe < 8) return 0;
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    return std::min(static_cast<std::size_t>(safe), max_blocks_per_thread * threads);
}

void take_photons(TracedBlock& block, const TraceTarget& target, TraceReport& report) {
    const std::uint64_t first = target.next_photon(report) % photons_per_block;
    std::uint64_t needed = target.missing_photons(report);
    if (const std::uint64_t hits = target.missing_hits(report))
        needed = std::max(needed, block.photons_with(hits, first) - first);
    const std::uint64_t end = std::min(photons_per_block, first + needed);
    if (first > 0 || end < photons_per_block) block.keep_photons(first, end);
    report.fates.add(block.fate);
    report.hits += block.hits.size();
}

}  // namespace common
