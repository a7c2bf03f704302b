#include "common/tracer/wave.h"

#include <algorithm>
#include <cmath>

namespace common {
namespace {

/// Blocks to the target number of hits, as far as what has been traced tells.
double blocks_to_hits(const TraceReport& so_far, const TraceTarget& target) {
    const double missing = static_cast<double>(target.hits - so_far.hits);
    // Until something is known: one hit for each photon, and a quarter of the way to learn more.
    const double photons_per_hit =
        so_far.hits == 0 ? 0.25
                         : static_cast<double>(so_far.fates.emitted) / static_cast<double>(so_far.hits);
    return missing * photons_per_hit / photons_per_block;
}

double blocks_to_photons(const TraceReport& so_far, const TraceTarget& target) {
    return static_cast<double>(target.photons - so_far.fates.emitted) / photons_per_block;
}

}  // namespace

std::size_t blocks_in_next_wave(const TraceReport& so_far, const TraceTarget& target) {
    const double wanted =
        target.hits > 0 ? blocks_to_hits(so_far, target) : blocks_to_photons(so_far, target);
    return static_cast<std::size_t>(
        std::clamp(std::ceil(wanted), 1.0, static_cast<double>(max_blocks_per_ordered_wave)));
}

std::size_t whole_blocks_ahead(const TraceReport& so_far, const TraceTarget& target) {
    if (target.next_photon(so_far) % photons_per_block != 0) return 0;
    if (target.hits > 0 && so_far.hits == 0) return 0;
    // Photons have their hits in different numbers: nine tenths of the way are safe from chance.
    const double safe =
        target.hits > 0 ? 0.9 * blocks_to_hits(so_far, target) : blocks_to_photons(so_far, target);
    if (safe < 8) return 0;
    return static_cast<std::size_t>(std::min(safe, static_cast<double>(max_blocks_per_unordered_wave)));
}

void take_photons(TracedBlock& block, const TraceTarget& target, TraceReport& report) {
    const std::uint64_t first = target.next_photon(report) % photons_per_block;
    std::uint64_t end = photons_per_block;
    if (target.photons > 0) end = std::min(end, first + target.photons - report.fates.emitted);
    if (target.hits > report.hits) end = std::min(end, block.photons_with(target.hits - report.hits, first));
    if (first > 0 || end < photons_per_block) block.keep_photons(first, end);
    report.fates.add(block.fate);
    report.hits += block.hits.size();
}

}  // namespace common
