#include "bench/experiments/bases/bases_table.h"

#include <fmt/format.h>

#include "bench/contenders/row_facts.h"
#include "bench/setup/provenance.h"

namespace bench::bases {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* definition =
    "Error in %: root mean square over 300 shading normals within 60 degrees of the geometric normal, "
    "uniform in "
    "solid angle, of (irradiance by the basis - true irradiance), divided by the mean of the true irradiance "
    "over "
    "these normals; mean and worst over the environments. The truth is the direct sum over the photons that "
    "the "
    "texel was given, so there is no noise: what is left is the basis. mean and worst are of the series "
    "itself, "
    "answered_mean and answered_worst of what the light map answers, which cuts off what is below zero. "
    "at_own_normal: series / truth at the geometric normal, mean. expected_mean and expected_worst: derived "
    "without this code, by quadrature over 60 environments drawn at random: for the means of the point "
    "lights one "
    "standard error of that is 2.7, 0.4 and 0.2 (L0, L2, L4). tests/bench/bases_test.cpp holds them "
    "to "
    "the integral "
    "over all directions, 75.9, 8.22 and 4.11, within 0.5 %.";

Json row_of(const BasisFigures& figures) {
    const auto expected = expected_figures(figures.light, figures.basis.name);
    const bool has_worst = expected && expected->worst;
    Json row = {{"light", name_of(figures.light)}, {"basis", figures.basis.name}};
    add_facts(row, parse_contender("bases", figures.basis.contender));
    row.update({{"numbers_per_texel", figures.basis.numbers},
                {"bytes_per_texel", figures.basis.bytes},
                {"environments", figures.environments},
                {"mean", figures.series.mean},
                {"worst", figures.series.worst},
                {"answered_mean", figures.answered.mean},
                {"answered_worst", figures.answered.worst},
                {"at_own_normal", figures.at_own_normal},
                {"expected_mean", expected ? Json(expected->mean) : Json(nullptr)},
                {"expected_worst", has_worst ? Json(*expected->worst) : Json(nullptr)}});
    return row;
}

Json tilt_as_json(const TiltCurve& tilt) {
    Json curves = Json::object(), answered = Json::object();
    const std::vector<Basis> bases = all_bases();
    for (std::size_t b = 0; b < bases.size(); ++b) {
        curves[bases[b].name] = tilt.answers[b].series;
        answered[bases[b].name] = tilt.answers[b].answered;
    }
    return {{"light_degrees", tilt.light_degrees},
            {"degrees", tilt.degrees},
            {"truth", tilt.truth},
            {"series", curves},
            {"answered", answered}};
}

/// Formats with three digits and never an exponent: 75.9, 0.802, 0.00416.
std::string percent_text(double percent) {
    if (percent >= 100) return fmt::format("{:.0f}", percent);
    if (percent >= 10) return fmt::format("{:.1f}", percent);
    if (percent >= 1) return fmt::format("{:.2f}", percent);
    return fmt::format("{:.3f}", percent);
}

std::string expected_text(const BasisFigures& figures) {
    const auto expected = expected_figures(figures.light, figures.basis.name);
    if (!expected) return "-";
    return expected->worst ? fmt::format("{:g} / {:g}", expected->mean, *expected->worst)
                           : fmt::format("{:g}", expected->mean);
}

/// Formats mean and worst; only one figure where there is one environment.
std::string errors_text(const ErrorFigures& errors, std::size_t environments) {
    if (environments == 1) return percent_text(errors.mean);
    return fmt::format("{} / {}", percent_text(errors.mean), percent_text(errors.worst));
}

}  // namespace

Json bases_as_json(std::span<const BasisFigures> figures, const TiltCurve& tilt, std::uint64_t seed) {
    Json context = provenance();
    context["seed"] = seed;
    Json lights = Json::object(), rows = Json::array();
    for (const LightKind kind : light_kinds) lights[name_of(kind)] = description_of(kind);
    for (const BasisFigures& one : figures) rows.push_back(row_of(one));
    return {{"context", context},
            {"definition", definition},
            {"lights", lights},
            {"rows", rows},
            {"tilt", tilt_as_json(tilt)}};
}

std::string bases_as_text(std::span<const BasisFigures> figures) {
    std::string text = fmt::format("{:<20} {:<18} {:>6} {:>16} {:>16} {:>16} {:>11}\n", "light", "basis",
                                   "bytes", "error %", "answered %", "expected %", "own normal");
    for (const BasisFigures& one : figures)
        text +=
            fmt::format("{:<20} {:<18} {:>6} {:>16} {:>16} {:>16} {:>11.4f}\n", name_of(one.light),
                        one.basis.name, one.basis.bytes, errors_text(one.series, one.environments),
                        errors_text(one.answered, one.environments), expected_text(one), one.at_own_normal);
    return text;
}

std::string bases_as_markdown(std::span<const BasisFigures> figures, std::uint64_t seed) {
    std::string text = fmt::format("# What a texel's basis loses at tilted normals\n\n{}\n\n", definition);
    for (const LightKind kind : light_kinds)
        text += fmt::format("- {}: {}\n", name_of(kind), description_of(kind));
    text += fmt::format(
        "\nSeed {}. Errors are mean / worst.\n\n"
        "| light | basis | numbers per texel | bytes per texel | environments | error % | answered % | "
        "expected % | "
        "at own normal |\n|---|---|---|---|---|---|---|---|---|\n",
        seed);
    for (const BasisFigures& one : figures)
        text += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {:.4f} |\n", name_of(one.light), one.basis.name,
            one.basis.numbers, one.basis.bytes, one.environments, errors_text(one.series, one.environments),
            errors_text(one.answered, one.environments), expected_text(one), one.at_own_normal);
    return text + "\n![](charts/bases.png)\n\n![](charts/bases-tilt.png)\n";
}

}  // namespace bench::bases
