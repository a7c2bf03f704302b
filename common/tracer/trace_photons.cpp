#include "common/tracer/trace_photons.h"

#include <fmt/format.h>

#include "common/core/input_error.h"

namespace common {

std::size_t blocks_in_next_wave(const TraceReport& so_far, const TraceTarget& target) {
    const double blocks_done = static_cast<double>(so_far.fates.emitted) / photons_per_block;
    double wanted = 0;
    if (target.photons > so_far.fates.emitted)
        wanted = static_cast<double>(target.photons - so_far.fates.emitted) / photons_per_block;
    if (target.hits > so_far.hits) {
        // Until something is known: one hit for each photon.
        const double hits_per_block =
            so_far.hits == 0 ? photons_per_block : static_cast<double>(so_far.hits) / blocks_done;
        wanted = std::max(wanted, static_cast<double>(target.hits - so_far.hits) / hits_per_block);
    }
    if (blocks_done == 0) wanted /= 4;  // a first taste, to learn how many hits a block has
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::min(wanted, 1e9)), 1, max_blocks_per_wave);
}

void check_that_photons_hit(const TraceReport& so_far, const TraceTarget& target) {
    constexpr std::uint64_t patience = 1 << 20;
    if (target.hits > 0 && so_far.hits == 0 && so_far.fates.emitted >= patience)
        throw InputError(
            fmt::format("the first {} photons hit no diffuse surface: no number of hits can be reached",
                        so_far.fates.emitted));
}

}  // namespace common
