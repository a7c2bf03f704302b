#include "bench/experiments/fit/truth.h"

#include <algorithm>
#include <cmath>

#include "common/reference/paths_not_found.h"
#include "common/reference/strata.h"

namespace bench::fit {
namespace {

namespace reference = common::reference;
using common::Rgb;

/// Distributes passes over the tiles: at least one each, and `mean` per point on average. They are
/// proportional to the 2/3 power of a tile's variance, which minimises the noise of the mean product of two
/// halves. The variance comes from earlier samples. New samples are independent of these, so the estimate
/// stays unbiased.
std::vector<std::uint64_t> shared_out(std::uint64_t mean, const Halves& before, const FitPoints& points) {
    const Measure measure(mean_of(before), points.tile, points.tiling);
    std::vector<double> variance(points.tiling.count()), count(points.tiling.count());
    for (std::size_t i = 0; i < points.tile.size(); ++i) {
        const Rgb difference = before.a[i] - before.b[i];
        for (int c = 0; c < 3; ++c)
            variance[points.tile[i]] += double{measure.weight[i][c]} * difference[c] * difference[c];
        ++count[points.tile[i]];
    }
    double sum = 0;
    std::vector<double> share(variance.size());
    for (std::size_t t = 0; t < share.size(); ++t) {
        if (count[t] == 0) continue;
        share[t] = std::cbrt(std::pow(variance[t] / count[t], 2));
        sum += share[t] * count[t];
    }
    const double to_share = static_cast<double>(mean - 1) * static_cast<double>(points.tile.size());
    std::vector<std::uint64_t> passes(share.size(), 1);
    for (std::size_t t = 0; t < share.size(); ++t)
        if (sum > 0) passes[t] += static_cast<std::uint64_t>(std::llround(to_share * share[t] / sum));
    return passes;
}

}  // namespace

PathTruth::PathTruth(const LoadedScene& loaded, const common::PhotonSource& source, const FitPoints& points,
                     std::uint64_t seed)
    : loaded_(loaded),
      points_(points),
      seed_(seed),
      most_surfaces_(static_cast<int>(source.most_events())),
      lost_light_(reference::paths_not_found(loaded.scene)),
      lights_(loaded.scene) {}

std::uint64_t PathTruth::samples_of(int level) {
    return std::uint64_t{reference::samples_per_pass} << level;
}

const Halves& PathTruth::at(int level, const StopRule& stop) {
    while (static_cast<int>(level_.size()) <= level) level_.push_back(next_level(stop));
    return level_[static_cast<std::size_t>(level)];
}

/// Doubles the samples, with more of the new ones in noisy tiles. Old and new means have equal weight
/// everywhere. Weights by their numbers of samples would be smaller for old means just where these are too
/// bright by chance.
Halves PathTruth::next_level(const StopRule& stop) const {
    // Unlike any likely --seed: the random numbers of a path are determined by seed, pixel and pass.
    constexpr std::uint64_t of_a = 0x7061'7468'2061'0000, of_b = 0x7061'7468'2062'0000;
    const std::uint64_t of_level = std::uint64_t{level_.size()} << 32;
    std::vector<std::uint64_t> passes(points_.tiling.count(), 1);
    if (!level_.empty()) passes = shared_out(std::uint64_t{1} << (level_.size() - 1), level_.back(), points_);
    Halves fresh{fresh_means(passes, seed_ ^ of_a ^ of_level, stop),
                 fresh_means(passes, seed_ ^ of_b ^ of_level, stop)};
    if (level_.empty()) return fresh;
    for (std::size_t i = 0; i < fresh.a.size(); ++i) {
        fresh.a[i] = 0.5f * (fresh.a[i] + level_.back().a[i]);
        fresh.b[i] = 0.5f * (fresh.b[i] + level_.back().b[i]);
    }
    return fresh;
}

std::vector<Rgb> PathTruth::fresh_means(std::span<const std::uint64_t> passes_of_tile, std::uint64_t seed,
                                        const StopRule& stop) const {
    std::vector<Rgb> sums(points_.seen.size(), Rgb(0, 0, 0));
    const std::uint64_t most = *std::max_element(passes_of_tile.begin(), passes_of_tile.end());
    for (std::uint64_t pass = 0; pass < most; ++pass) {
        std::vector<std::size_t> place;
        std::vector<common::VisibleSurface> seen;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (passes_of_tile[points_.tile[i]] <= pass) continue;
            place.push_back(i);
            seen.push_back(points_.seen[i]);
        }
        const std::vector<Rgb> means = one_pass(seen, seed ^ (pass << 40), stop);
        for (std::size_t k = 0; k < place.size(); ++k) sums[place[k]] += means[k];
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] /= static_cast<float>(passes_of_tile[points_.tile[i]]);
    return sums;
}

std::vector<Rgb> PathTruth::one_pass(std::span<const common::VisibleSurface> seen, std::uint64_t seed,
                                     const StopRule& stop) const {
    reference::ReferenceSums sums(seen.size());
    const auto keep_going = [&](std::size_t) { return !stop.over(); };
    if (!reference::add_pass(loaded_.rays, lights_, seen, seed, sums, keep_going, most_surfaces_))
        stop.check();
    std::vector<Rgb> means(seen.size());
    for (std::size_t i = 0; i < means.size(); ++i)
        for (int c = 0; c < 3; ++c) means[i][c] = sums.pixel[i][c].mean().high;
    return means;
}

}  // namespace bench::fit
