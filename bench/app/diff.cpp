#include "bench/app/diff.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/input_error.h"
#include "common/difference/error_map.h"
#include "common/difference/error_metrics.h"
#include "common/difference/flip.h"
#include "common/difference/flip_exposures.h"
#include "common/difference/image_layer.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

struct DiffOptions {
    std::string image, reference, flip_map;
    std::optional<double> most_relmse;
    bool json = false;
};

struct Flip {
    std::vector<float> map;  ///< every pixel
    double mean = 0;         ///< over the compared pixels
};

void check(const DiffOptions& options) {
    if (options.most_relmse && !(std::isfinite(*options.most_relmse) && *options.most_relmse >= 0))
        throw common::InputError("--fail-relmse: a number, 0 or more");
    if (!options.flip_map.empty() && std::filesystem::path(options.flip_map).extension() != ".png")
        throw common::InputError("--flip-map: the map is a .png file");
}

template <class T>
std::vector<T> selected(const std::vector<T>& values, const std::vector<std::size_t>& places) {
    std::vector<T> chosen;
    chosen.reserve(places.size());
    for (const std::size_t place : places) chosen.push_back(values[place]);
    return chosen;
}

/// The image where it is compared; the reference elsewhere, so that FLIP, which looks around every pixel,
/// sees no difference there.
std::vector<common::Rgb> image_in_reference(const common::ComparableImages& both) {
    std::vector<common::Rgb> pixels = both.reference;
    for (const std::size_t place : both.compared) pixels[place] = both.image[place];
    return pixels;
}

Flip flip(const common::ComparableImages& both) {
    std::vector<float> map =
        common::flip_map(image_in_reference(both), both.reference, both.width, both.height);
    const double mean = common::mean(selected(map, both.compared));
    return {std::move(map), mean};
}

Json worst_value(const common::WorstValue& worst, const common::ComparableImages& both) {
    const std::size_t place = both.compared[worst.pixel], width = both.width;
    constexpr std::array<const char*, 3> names = {"R", "G", "B"};
    return {{"x", place % width},
            {"y", place / width},
            {"channel", names[worst.channel]},
            {"image", worst.image},
            {"reference", worst.reference}};
}

Json all_figures(const DiffOptions& options, const common::ComparableImages& both,
                 const common::DifferenceFigures& figures, const Flip& flip) {
    const common::Exposures exposures = common::exposures_for(both.reference);
    const std::size_t pixels = both.reference.size(), compared = both.compared.size();
    return {{"image", options.image},
            {"reference", options.reference},
            {"layer", both.layer},
            {"width", both.width},
            {"height", both.height},
            {"pixels_compared", compared},
            {"pixels_left_out", pixels - compared},
            {"coverage_differs", both.coverage_differs ? Json(*both.coverage_differs) : Json(nullptr)},
            {"non_finite", 0},  // else there would be no figures
            {"epsilon", figures.epsilon},
            {"mean_image", figures.mean_image},
            {"mean_reference", figures.mean_reference},
            {"relmse", figures.relmse},
            {"relative_rms", figures.relative_rms},
            {"rmse", figures.rmse},
            {"smape", figures.smape},
            {"bias", figures.bias},
            {"relative_bias", figures.relative_bias},
            {"relative_error_p99", figures.relative_error_p99},
            {"relative_error_max", figures.relative_error_max},
            {"worst", worst_value(figures.worst, both)},
            {"flip", flip.mean},
            {"flip_pixels_per_degree", common::flip_pixels_per_degree},
            {"flip_exposures",
             {{"start", exposures.start}, {"stop", exposures.stop}, {"count", exposures.count}}}};
}

void print(const Json& figures, bool json) {
    if (json) {
        fmt::print("{}\n", figures.dump(2));
        return;
    }
    for (const auto& [key, value] : figures.items())
        fmt::print("{:<22} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
}

void run(const DiffOptions& options) {
    check(options);
    const common::ComparableImages both = common::load_comparable(options.image, options.reference);
    const common::DifferenceFigures figures =
        common::difference(selected(both.image, both.compared), selected(both.reference, both.compared));
    const Flip seen = flip(both);
    if (!options.flip_map.empty())
        common::write_flip_map(options.flip_map, both.width, both.height, seen.map);
    print(all_figures(options, both, figures, seen), options.json);
    // So put that a relMSE that is no number is no success.
    if (options.most_relmse && !(figures.relmse <= *options.most_relmse))
        throw BoundExceeded(fmt::format("{}: relMSE {:g} is more than {:g}", options.image, figures.relmse,
                                        *options.most_relmse));
}

}  // namespace

void add_diff_command(CLI::App& app) {
    const auto options = std::make_shared<DiffOptions>();
    CLI::App* command = app.add_subcommand("diff", "Say how far an image is from a reference");
    command->add_option("IMAGE", options->image, "Linear image, .exr")->required();
    command->add_option("REFERENCE", options->reference, "Linear image of the same size, .exr")->required();
    command->add_option("--fail-relmse", options->most_relmse, "Exit with 1 where relMSE is more than this");
    command->add_option("--flip-map", options->flip_map, "PNG to write: where a viewer sees a difference");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options] { run(*options); });
}

}  // namespace bench
