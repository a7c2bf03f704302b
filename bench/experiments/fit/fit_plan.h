// The checked options of a fit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/experiments/fit/choice.h"
#include "bench/setup/command.h"
#include "bench/setup/run_options.h"
#include "bench/setup/scene_options.h"

namespace bench::fit {

struct FitOptions {
    std::string file, budget_bytes, budget_time, time, max_hits = "1e9", pilot = "1.28e8";
    std::vector<std::string> targets, least = {"time"};
    std::string max_memory, verify, out;
    std::size_t seeds = 3;
    bool json = false, list = false, explain = false;
    SceneOptions scene;
    RunOptions run;

    void add_to(Command& command);
};

struct FitPlan {
    std::string file;
    std::vector<FitGoal> goals;  ///< each target by each of `least`
    std::uint64_t pilot_hits;    ///< upper limit for each half
    double seconds;              ///< limit of a goal's search; the first pilot is always finished
    std::size_t max_bytes;
    std::optional<std::filesystem::path> reference;  ///< to verify with
    std::size_t seeds;                               ///< runs of each verification
    bool explain;                                    ///< say why the light map is what it is
    std::optional<std::filesystem::path> out;        ///< exists and can be written to; a folder in it for
                                                     ///< each of several goals
    SceneOptions scene;
    ContenderSettings settings;
    std::uint64_t seed;
    int threads;

    /// Returns where the results of a goal go: with several goals, each has a folder of its own, such as
    /// 5-time. `out` must be set.
    [[nodiscard]] std::filesystem::path folder_of(const FitGoal& goal) const;
};

/// Checks the options and makes the output folder. Throws InputError for the first option that makes no
/// sense.
[[nodiscard]] FitPlan make_plan(const FitOptions& options);

}  // namespace bench::fit
