#include "bench/experiments/fit/truth.h"

#include "common/core/progress.h"
#include "common/reference/paths_not_found.h"
#include "common/reference/strata.h"

namespace bench::fit {
namespace {

namespace reference = common::reference;

// Far from what anybody gives as --seed: the numbers of a path belong to its seed, pixel and pass.
constexpr std::uint64_t seed_of_a = 0x7061'7468'2061'0000, seed_of_b = 0x7061'7468'2062'0000;

std::vector<common::Rgb> means_of(const reference::ReferenceSums& sums) {
    std::vector<common::Rgb> means(sums.pixel.size());
    for (std::size_t i = 0; i < means.size(); ++i)
        for (int c = 0; c < 3; ++c) means[i][c] = sums.pixel[i][c].mean().high;
    return means;
}

}  // namespace

PathTruth::PathTruth(const LoadedScene& loaded, const common::PhotonSource& source, const FitPoints& points,
                     std::uint64_t seed)
    : loaded_(loaded),
      points_(points),
      seed_(seed),
      most_surfaces_(static_cast<int>(source.most_events())),
      lost_light_(reference::paths_not_found(loaded.scene)),
      lights_(loaded.scene),
      a_(points.seen.size()),
      b_(points.seen.size()) {}

std::uint64_t PathTruth::samples_of(int level) {
    return std::uint64_t{reference::samples_per_pass} << level;
}

const Halves& PathTruth::at(int level, const StopRule& stop) {
    while (static_cast<int>(level_.size()) <= level) {
        const std::uint64_t passes = std::uint64_t{1} << level_.size();
        while (b_.passes < passes) {
            if (a_.passes == b_.passes) add_pass(a_, seed_ ^ seed_of_a, stop);
            add_pass(b_, seed_ ^ seed_of_b, stop);
        }
        level_.push_back({means_of(a_), means_of(b_)});
    }
    return level_[static_cast<std::size_t>(level)];
}

void PathTruth::add_pass(reference::ReferenceSums& sums, std::uint64_t seed, const StopRule& stop) {
    const auto keep_going = [&](std::size_t) { return !stop.over(); };
    if (!reference::add_pass(loaded_.rays, lights_, points_.seen, seed, sums, keep_going, most_surfaces_))
        stop.check();
}

}  // namespace bench::fit
