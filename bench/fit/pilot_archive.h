// Pilots that were traced, for all goals of a fit: most of what they ask is the same.
#pragma once

#include <map>

#include "bench/fit/pilot.h"

namespace bench::fit {

class PilotArchive {
  public:
    /// Of all_candidates(), in their order.
    explicit PilotArchive(std::span<const Candidate> candidates) : candidates_(candidates) {}

    /// As run_pilot, but what was traced with so many hits before is taken from there: the same answers, as
    /// photons are counted and stores know nothing of each other. Throws Interrupted.
    void run_pilot(const PilotSubject& subject, std::span<const std::size_t> chosen, std::uint64_t hits,
                   std::vector<PilotSample>& samples);

  private:
    std::span<const Candidate> candidates_;
    std::map<std::uint64_t, std::vector<PilotSample>> by_hits_;  ///< of each half
};

}  // namespace bench::fit
