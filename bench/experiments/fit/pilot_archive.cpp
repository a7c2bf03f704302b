#include "bench/experiments/fit/pilot_archive.h"

namespace bench::fit {

void PilotArchive::run_pilot(const PilotSubject& subject, std::span<const std::size_t> chosen,
                             std::uint64_t hits, std::vector<PilotSample>& samples) {
    std::vector<PilotSample>& known = by_hits_[hits];
    known.resize(candidates_.size());
    std::vector<std::size_t> unknown;
    for (const std::size_t i : chosen)
        if (!known[i].present()) unknown.push_back(i);
    fit::run_pilot(subject, candidates_, unknown, hits, known);
    for (const std::size_t i : chosen)
        if (known[i].present()) samples[i] = known[i];
}

}  // namespace bench::fit
