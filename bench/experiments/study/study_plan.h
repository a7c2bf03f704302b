// The checked options of a study.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/contenders/contender_options.h"
#include "bench/contenders/direct_light.h"
#include "bench/setup/command.h"
#include "bench/setup/emission_option.h"
#include "bench/setup/run_options.h"

namespace bench::study {

struct StudyOptions {
    std::vector<std::string> files;
    std::vector<std::string> hits = {"1e4", "1e5", "1e6", "1e7"};
    std::vector<std::string> methods = {"shlm/L2/radiance/surface4",
                                        "shlm/L2/radiance/knn4",
                                        "shlm/L2/radiance/own",
                                        "shlm/L2/radiance/bilinear",
                                        "shlm/L2/radiance/surface4/h0",
                                        "shlm/L2/radiance/surface8",
                                        "shlm/L0/normalised/surface4",
                                        "shlm/F1/radiance/surface4",
                                        "shlm/F2/radiance/surface4",
                                        "shlm/L4/radiance/surface4",
                                        "shlm/L2/flux/surface4",
                                        "shlm/L2/normalised/surface4",
                                        "shlm/L2/radiance/surface4/t4096",
                                        "shlm/L2/radiance/surface4/t16384",
                                        "shlm/L2/radiance/surface4/t65536",
                                        "shlm/L2/radiance/surface4/t1048576",
                                        "photonmap/compact/k50/disc",
                                        "photonmap/compact/k50/cone",
                                        "photonmap/compact/k50/epanechnikov",
                                        "photonmap/compact/k200/disc",
                                        "photonmap/compact/k0.01n23/disc",
                                        "photonmap/compact/k0.01n23/epanechnikov",
                                        "photonmap/compact/r0.00075/epanechnikov",
                                        "photonmap/compact/r0.0015/epanechnikov",
                                        "photonmap/compact/r0.003/disc",
                                        "photonmap/compact/r0.003/epanechnikov",
                                        "photonmap/compact/r0.006/epanechnikov",
                                        "photonmap/compact/r0.012/epanechnikov"};
    std::string references = "results/references";
    std::string out = "results/study";
    std::string max_memory;
    std::size_t seeds = 8;
    bool anew = false;
    SceneOptions scene;
    MethodOptions method_options;
    DirectOptions direct;
    EmissionOption emission;
    int threads = 0;

    void add_to(Command& command);
};

struct StudyPlan {
    std::vector<std::filesystem::path> files;
    std::vector<std::uint64_t> hits;  ///< ascending, each once
    std::vector<Contender> methods;   ///< methods that share a store are neighbours
    std::filesystem::path references;
    std::filesystem::path out;  ///< exists and can be written to
    std::size_t max_bytes;
    std::uint64_t seeds;  ///< seeds are 1 to this
    bool anew;            ///< start again where the folder's rows are of another build, machine or setting
    SceneOptions scene;
    ContenderSettings settings;
    int threads;

    [[nodiscard]] std::filesystem::path reference_of(const std::filesystem::path& file) const {
        return references / (file.stem().string() + ".exr");
    }
};

/// Checks the options and makes the output folder. Throws InputError for the first option that makes no
/// sense.
[[nodiscard]] StudyPlan make_plan(const StudyOptions& options);

}  // namespace bench::study
