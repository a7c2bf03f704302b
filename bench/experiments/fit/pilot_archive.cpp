#include "bench/experiments/fit/pilot_archive.h"

namespace bench::fit {

void PilotArchive::run_pilot(std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
                             std::vector<PilotSample>& samples) {
    std::vector<PilotSample>& known = by_hits_[hits];
    known.resize(candidates_.size());
    std::vector<std::size_t> unknown;
    for (const std::size_t i : chosen)
        if (!known[i].present()) unknown.push_back(i);
    fit::run_pilot(subject_, candidates_, unknown, hits, stop, known);
    for (const std::size_t i : chosen)
        if (known[i].present()) samples[i] = known[i];
}

}  // namespace bench::fit
