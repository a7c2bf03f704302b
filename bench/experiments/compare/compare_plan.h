// The checked options of a comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/contenders/contender_options.h"
#include "bench/contenders/direct_light.h"
#include "bench/setup/command.h"
#include "bench/setup/emission_option.h"
#include "bench/setup/run_options.h"

namespace bench::compare {

struct CompareOptions {
    std::vector<std::string> files;
    std::vector<std::string> hits = {"1e4", "1e5", "1e6", "1e7"};
    std::vector<std::string> methods = {"photonmap/flann", "photonmap/flann-incremental", "shlm"};
    std::string out = "results/latest";
    std::string max_memory;
    std::size_t repetitions = 9;
    double seconds_per_size = 1e9;
    SceneOptions scene;
    MethodOptions method_options;
    DirectOptions direct;
    EmissionOption emission;
    RunOptions run;

    void add_to(Command& command);
};

struct ComparePlan {
    std::vector<std::string> files;
    std::vector<std::uint64_t> hits;  ///< ascending, each once
    std::vector<Contender> methods;
    std::filesystem::path out;  ///< exists and can be written to
    std::size_t max_bytes;
    std::size_t repetitions;
    double seconds_per_size;  ///< limit for one scene and size: no repetition begins that would exceed it
    SceneOptions scene;
    ContenderSettings settings;
    int threads;
    std::uint64_t seed;
};

/// Checks the options and makes the output folder. Throws InputError for the first option that makes no
/// sense.
[[nodiscard]] ComparePlan make_plan(const CompareOptions& options);

}  // namespace bench::compare
