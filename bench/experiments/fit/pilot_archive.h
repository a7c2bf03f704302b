// What was traced, for all goals of a fit: most of what they ask is the same.
#pragma once

#include <map>

#include "bench/experiments/fit/pilot.h"
#include "bench/experiments/fit/truth.h"

namespace bench::fit {

class PilotArchive {
  public:
    /// `subject` must outlive it.
    explicit PilotArchive(const PilotSubject& subject)
        : subject_(subject), truth_(subject.loaded, subject.source, subject.points, subject.seed) {}

    [[nodiscard]] const PilotSubject& subject() const { return subject_; }
    [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }
    [[nodiscard]] PathTruth& truth() { return truth_; }

    /// As run_pilot of all candidates, but what was traced with so many hits before is taken from there: the
    /// same answers, as photons are counted and stores know nothing of each other. Throws Stopped.
    void run_pilot(std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
                   std::vector<PilotSample>& samples);

  private:
    const PilotSubject& subject_;
    std::vector<Candidate> candidates_ = all_candidates();
    std::map<std::uint64_t, std::vector<PilotSample>> by_hits_;  ///< of each half
    PathTruth truth_;
};

}  // namespace bench::fit
