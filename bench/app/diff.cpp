// shlmbench diff: compares an image with a reference.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/image_output.h"
#include "bench/setup/numbers.h"
#include "common/core/input_error.h"
#include "common/core/standard_streams.h"
#include "common/difference/error_map.h"
#include "common/difference/error_metrics.h"
#include "common/difference/flip.h"
#include "common/difference/flip_exposures.h"
#include "common/difference/image_layer.h"
#include "common/reference/paths_not_found.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

struct DiffOptions {
    std::string image, reference, flip_map;
    std::optional<double> most_relmse;
    bool json = false;
};

struct Measured {
    common::DifferenceFigures figures;
    common::Exposures exposures;  ///< the exposures that FLIP used: those for the compared pixels
    std::vector<float> flip_map;  ///< every pixel
    double flip = 0;              ///< mean over the compared pixels
};

void check(const DiffOptions& options) {
    if (options.most_relmse && *options.most_relmse < 0)
        throw common::InputError("--fail-relmse: a number, 0 or more");
    if (!options.flip_map.empty() && std::filesystem::path(options.flip_map).extension() != ".png")
        throw common::InputError("--flip-map: the map is a .png file");
    if (!options.flip_map.empty())
        check_png_output("--flip-map", options.flip_map, common::picture_of_errors);
}

template <class T>
std::vector<T> selected(const std::vector<T>& values, const std::vector<std::size_t>& places) {
    std::vector<T> chosen;
    chosen.reserve(places.size());
    for (const std::size_t place : places) chosen.push_back(values[place]);
    return chosen;
}

/// Returns the image where it is compared, and the reference elsewhere. FLIP filters around every pixel and
/// thus sees no difference there.
std::vector<common::Rgb> image_in_reference(const common::ComparableImages& both) {
    std::vector<common::Rgb> pixels = both.reference;
    for (const std::size_t place : both.compared) pixels[place] = both.image[place];
    return pixels;
}

Measured measure_images(const common::ComparableImages& both) {
    const std::vector<common::Rgb> reference = selected(both.reference, both.compared);
    const common::DifferenceFigures figures =
        common::difference(selected(both.image, both.compared), reference);
    const common::Exposures exposures = common::exposures_for(reference);
    std::vector<float> map =
        common::flip_map(image_in_reference(both), both.reference, both.width, both.height, exposures);
    const double flip = common::flip_mean(selected(map, both.compared));
    return {figures, exposures, std::move(map), flip};
}

Json worst_value(const common::WorstValue& worst, const common::ComparableImages& both) {
    const std::size_t place = both.compared[worst.pixel], width = both.width;
    constexpr std::array<const char*, 3> names = {"R", "G", "B"};
    return {{"x", both.x + place % width},
            {"y", both.y + place / width},
            {"channel", names[worst.channel]},
            {"image", worst.image},
            {"reference", worst.reference}};
}

Json facts(const DiffOptions& options, const common::ComparableImages& both, const Measured& measured) {
    const common::DifferenceFigures& figures = measured.figures;
    const common::Exposures& exposures = measured.exposures;
    const std::size_t pixels = both.reference.size(), compared = both.compared.size();
    return {{"image", options.image},
            {"reference", options.reference},
            {"layer", both.layer},
            {"width", both.width},
            {"height", both.height},
            {"pixels_compared", compared},
            {"pixels_left_out", pixels - compared},
            {"coverage_differs", both.coverage_differs ? Json(*both.coverage_differs) : Json(nullptr)},
            {"non_finite", 0},  // other images are refused
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
            {"worst_share", figures.worst_share},
            {"flip", measured.flip},
            {"flip_pixels_per_degree", common::flip_pixels_per_degree},
            {"flip_exposures",
             {{"start", exposures.start}, {"stop", exposures.stop}, {"count", exposures.count}}}};
}

/// Formats for people: six digits, and no braces.
std::string text_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
    if (!value.is_object()) return value.dump();
    std::string text;
    for (const auto& [key, part] : value.items())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, text_of(part));
    return text;
}

void print(const Json& facts, bool json) {
    if (json) {
        common::print_result(fmt::format(
            "{}\n", facts.dump(2, ' ', false, Json::error_handler_t::replace)));  // odd file names
        return;
    }
    for (const auto& [key, value] : facts.items())
        if (!value.is_null()) common::print_result(fmt::format("{:<22} {}\n", key, text_of(value)));
}

/// Adds the reference's file name to the error if it cannot be compared with.
Measured measure(const DiffOptions& options, const common::ComparableImages& both) {
    try {
        return measure_images(both);
    } catch (const common::InputError& e) {
        throw common::InputError(fmt::format("{}: {}", options.reference, e.what()));
    }
}

/// Refuses a reference that lacks some light that the image may have.
void require_the_same_light(const DiffOptions& options) {
    using common::reference::paths_not_found;
    const std::string lost = paths_not_found(common::read_notes(options.reference));
    if (!lost.empty() && paths_not_found(common::read_notes(options.image)) != lost)
        throw common::InputError(fmt::format("{}: no measure for an image that may have what it lacks: {}",
                                             options.reference, lost));
}

void run(const DiffOptions& options) {
    check(options);
    const common::ComparableImages both = common::load_comparable(options.image, options.reference);
    require_the_same_light(options);
    const Measured measured = measure(options, both);
    if (!options.flip_map.empty())
        common::write_flip_map(options.flip_map, both.width, both.height, measured.flip_map);
    print(facts(options, both, measured), options.json);
    const double relmse = measured.figures.relmse;
    if (options.most_relmse && !(relmse <= *options.most_relmse))  // this form also refuses NaN
        throw BoundExceeded(
            fmt::format("{}: relMSE {:g} is more than {:g}", options.image, relmse, *options.most_relmse));
}

const RegisteredCommand registered(8, {.name = "diff",
                                       .purpose = "Say how far an image is from a reference",
                                       .add_to = [](Command& command) -> std::function<void()> {
                                           const auto options = std::make_shared<DiffOptions>();
                                           command.option("IMAGE", options->image, "Linear image, .exr",
                                                          Need::required);
                                           command.option("REFERENCE", options->reference,
                                                          "Linear image of the same size and place, .exr",
                                                          Need::required);
                                           command.number("--fail-relmse", options->most_relmse,
                                                          "Exit with 1 where relMSE is more than this");
                                           command.option("--flip-map", options->flip_map,
                                                          "PNG to write: where a viewer sees a difference");
                                           command.flag("--json", options->json, "Print JSON");
                                           return [options] { run(*options); };
                                       }});

}  // namespace

}  // namespace bench
