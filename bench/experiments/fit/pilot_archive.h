// Keeps the pilots' samples for all goals of a fit, which need mostly the same ones.
#pragma once

#include <map>

#include "bench/experiments/fit/pilot.h"
#include "bench/experiments/fit/truth.h"

namespace bench::fit {

class PilotArchive {
  public:
    /// Keeps a reference to `subject`, which must outlive it.
    explicit PilotArchive(const PilotSubject& subject)
        : subject_(subject), truth_(subject.loaded, subject.source, subject.points, subject.seed) {}

    [[nodiscard]] const PilotSubject& subject() const { return subject_; }
    [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }
    [[nodiscard]] PathTruth& truth() { return truth_; }

    /// Does what run_pilot does for all candidates, but reuses samples that were traced with so many hits
    /// before. They are the same, since photons are counted and stores are independent of each other. Throws
    /// Stopped.
    void run_pilot(std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
                   std::vector<PilotSample>& samples);

  private:
    const PilotSubject& subject_;
    std::vector<Candidate> candidates_ = all_candidates();
    std::map<std::uint64_t, std::vector<PilotSample>> by_hits_;  ///< of each half
    PathTruth truth_;
};

}  // namespace bench::fit
