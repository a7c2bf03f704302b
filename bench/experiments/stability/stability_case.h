// Defines a stability case: a small scene, one swept parameter, what theory predicts, and what the methods
// do.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/image/image.h"

namespace bench::stability {

/// The parameters of one run of a case.
class CaseRun {
  public:
    /// Called before each seed; throws to end the run.
    using NextSeed = std::function<void()>;

    /// `mutation` is one of the case's own, or empty. `seeds`: 0 for enough to estimate a deviation well.
    CaseRun(bool full, std::string mutation = {}, NextSeed next_seed = {}, std::uint64_t seeds = 0)
        : full_(full),
          mutation_(std::move(mutation)),
          next_seed_(std::move(next_seed)),
          seeds_(seeds > 0 ? seeds
                 : full    ? 32
                           : 12) {}

    /// Returns the first value in the full form, the second one in the short form.
    template <class T>
    [[nodiscard]] T either(T full, T quick) const {
        return full_ ? full : quick;
    }
    [[nodiscard]] bool full() const { return full_; }

    /// Returns whether this run is to be wrong in the named way.
    [[nodiscard]] bool has_mutation(std::string_view name) const { return mutation_ == name; }

    /// Returns the number of independent repetitions.
    [[nodiscard]] std::uint64_t seeds() const { return seeds_; }

    /// Calls `measure(seed)` for the seeds 1, 2, ...
    template <class Measure>
    void for_each_seed(Measure measure) const {
        for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
            if (next_seed_) next_seed_();
            measure(seed);
        }
    }

  private:
    bool full_;
    std::string mutation_;
    NextSeed next_seed_;
    std::uint64_t seeds_;
};

struct StabilityPoint {
    double at;                       ///< the swept parameter
    double predicted;                ///< by theory
    double allowed = 0;              ///< absolute error of the theory itself: a series' next term, rounding
    std::vector<double> measured{};  ///< one for each seed; a single one where nothing is random
};

/// The criterion for a curve's points.
enum class Expected {
    equal,    ///< the mean is the prediction, within its confidence interval and `allowed`
    at_most,  ///< the mean is not above that
    shown     ///< not judged: drawn for comparison, such as a method before its remedy
};

struct StabilityCurve {
    std::string name;  ///< which method, and how: "photon map, normal test"
    Expected expected = Expected::equal;
    std::vector<StabilityPoint> points;
};

/// Makes a curve without measurements, with the prediction `predicted(at)` at each of the places.
template <class Predicted>
[[nodiscard]] StabilityCurve curve_at(std::string name, std::span<const double> places, Predicted predicted,
                                      Expected expected = Expected::equal, double allowed = 0) {
    StabilityCurve curve{std::move(name), expected, {}};
    for (const double at : places) curve.points.push_back({at, predicted(at), allowed});
    return curve;
}

/// A case. Its texts are for people; names are lower case words joined by hyphens.
struct StabilityCase {
    std::string name;
    std::string purpose;                 ///< what fails, and who is affected
    std::string scene;                   ///< the scene in words, with what the seeds vary
    std::string swept, measured;         ///< labels of both axes, with units
    std::string theory;                  ///< formula of the prediction, and its source
    std::string advice;                  ///< the remedy that is on by default, or what to avoid
    std::vector<std::string> mutations;  ///< each makes the case fail
    std::vector<StabilityCurve> (*run)(const CaseRun&);
    bool logarithmic_swept = false, logarithmic_measured = false;
    /// An optional picture, where it says more than numbers; linear values with R, G, B.
    std::optional<common::Image> (*picture)() = nullptr;
};

/// Returns all cases, in the order of their numbers.
[[nodiscard]] std::vector<const StabilityCase*> stability_cases();

/// Registers a case until the program ends. The file of each case has one of these.
class RegisteredCase {
  public:
    /// `number`: its unique position in lists.
    RegisteredCase(int number, const StabilityCase& stability_case);
};

}  // namespace bench::stability
