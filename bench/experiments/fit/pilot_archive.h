// Pilots that were traced, for all goals of a fit: most of what they ask is the same.
#pragma once

#include <map>

#include "bench/experiments/fit/pilot.h"

namespace bench::fit {

class PilotArchive {
  public:
    /// As run_pilot of all_candidates(), but what was traced with so many hits before is taken from there:
    /// the same answers, as photons are counted and stores know nothing of each other. Throws Interrupted.
    void run_pilot(const PilotSubject& subject, std::span<const std::size_t> chosen, std::uint64_t hits,
                   std::vector<PilotSample>& samples);

  private:
    std::vector<Candidate> candidates_ = all_candidates();
    std::map<std::uint64_t, std::vector<PilotSample>> by_hits_;  ///< of each half
};

}  // namespace bench::fit
