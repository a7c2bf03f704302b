// Measures how far the methods' images are from the stored references, and what to expect.
#pragma once

#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/image/image.h"
#include "tests/support/child_process.h"
#include "tests/support/statistics.h"

namespace reference_difference {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

inline constexpr std::array<const char*, 4> scenes = {"cornell", "bumpy", "caustic", "atrium"};

/// The render settings: the size of the references, and a dozen hits per texel.
inline const Words drawing = {"--width", "96", "--height", "54", "--texels", "16384", "--hits", "200000"};

/// The seeds over which the bounds are measured.
inline constexpr std::uint64_t first_seed = 101;
inline constexpr int seed_count = 16;

struct Subject {
    std::string scene, method;
};

/// Returns what is compared. A light map without directions ignores bumpy's normal maps.
inline std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const std::string scene : scenes)
        for (const char* method :
             {"shlm/L2/radiance/knn4", "shlm/L0/normalised/bilinear", "photonmap/flann/k50/disc"})
            if (scene != "bumpy" || !std::string(method).starts_with("shlm/L0"))
                all.push_back({scene, method});
    return all;
}

inline fs::path reference_of(const std::string& scene) {
    return fs::path(SHLMBENCH_REFERENCE_FOLDER) / (scene + ".exr");
}

inline fs::path bounds_file() {
    return fs::path(SHLMBENCH_GOLDEN_FOLDER) / "difference_bounds.json";
}

/// Identifies a reference. Its relative error has six digits and changes with every sample.
inline Json identity_of(const fs::path& reference) {
    const common::ImageNotes notes = common::read_notes(reference);
    Json identity;
    for (const char* name : {"fingerprint", "samples_per_pixel", "seed", "relative_error"})
        identity[name] = notes.at(fmt::format("shlmbench:{}", name));
    return identity;
}

/// Runs the project's command; its output goes to files in `folder`.
inline child_process::Ended run(const Words& words, const fs::path& folder) {
    return child_process::Child(fs::path(SHLMBENCH_BINARY_DIR) / "shlmbench", words, folder).wait();
}

/// Renders the image. Throws std::runtime_error where that fails.
inline void render(const Subject& subject, std::uint64_t seed, const fs::path& image) {
    Words words = {"render",   fmt::format("{}/scenes/{}.glb", SHLMBENCH_BINARY_DIR, subject.scene),
                   "--method", subject.method,
                   "--seed",   std::to_string(seed),
                   "--out",    image.string()};
    words.insert(words.end(), drawing.begin(), drawing.end());
    const auto ended = run(words, image.parent_path());
    if (ended.exit_code != 0) throw std::runtime_error(ended.err);
}

/// Figures as shlmbench diff reports them.
struct Figures {
    double relmse, relative_bias;
};

struct Comparison {
    Figures figures;
    bool fails;  ///< whether the command's exit code says so
};

/// Compares an image with the scene's reference; `most_relmse` becomes --fail-relmse. Throws
/// std::runtime_error where the two cannot be compared.
inline Comparison compare(const fs::path& image, const std::string& scene,
                          std::optional<double> most_relmse = std::nullopt) {
    Words words = {"diff", image.string(), reference_of(scene).string(), "--json"};
    if (most_relmse) words.insert(words.end(), {"--fail-relmse", fmt::format("{:.17g}", *most_relmse)});
    const auto ended = run(words, image.parent_path());
    if (ended.exit_code != 0 && ended.exit_code != 1) throw std::runtime_error(ended.err);
    const Json found = Json::parse(ended.out);
    return {{found["relmse"], found["relative_bias"]}, ended.exit_code == 1};
}

struct Interval {
    double low, high;

    /// NaN is never contained.
    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
};

/// Mean and standard deviation of a normal distribution, estimated from `count` values.
struct Spread {
    double mean, standard_deviation;
    int count;

    /// Returns the interval that one more value leaves with probability `alpha` (Student's t, as both mean
    /// and deviation are estimates).
    [[nodiscard]] Interval prediction(double alpha) const {
        const double reach = tests::t_for(alpha, count - 1) * standard_deviation * std::sqrt(1 + 1.0 / count);
        return {mean - reach, mean + reach};
    }
};

}  // namespace reference_difference
