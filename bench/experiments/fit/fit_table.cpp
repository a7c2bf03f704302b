#include "bench/experiments/fit/fit_table.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/experiments/fit/explanation_table.h"
#include "bench/setup/provenance.h"
#include "common/scene/fingerprint.h"

namespace bench::fit {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t rows_of_table = 12;

constexpr const char* fit_definition =
    "Errors are relative RMS over the points that the camera sees in 96 x 54 pixels, at a place drawn in "
    "each, three channels: "
    "the root of mean (I - R)^2 / (R^2 + eps), eps = 0.01 (mean R)^2. noise, blur and truncation are the "
    "parts of "
    "the estimated error; their squares add up to its. bound: what nine of ten runs stay below if the "
    "estimates are "
    "right; paths from the points tell the bias. All but `verified` is found without a reference. seconds: "
    "trace, insertion, index and all answers; prepare_seconds: once for the scene.";

constexpr const char* explanation_words =
    "By mesh instance, the most error first: its share of the points, what of the map's squared error arises "
    "there, and the error there alone with its parts, each by the same halves of the pilot as the map's own. "
    "keeps: what its blocks keep, by their share of the picture; median block: the width of the block that "
    "the "
    "middle pixel sees, scene units.";

Json proposal_as_json(const FitResult& result, const Proposal& proposal, const FitGoal& goal) {
    const Candidate& candidate = result.candidates[proposal.candidate];
    const ErrorModel& model = proposal.model;
    const double error_sq = model.error_sq(proposal.hits);
    Json row = {{"method", candidate.name(static_cast<std::uint64_t>(proposal.hits))},
                {"hits", static_cast<std::uint64_t>(proposal.hits)},
                {"error", std::sqrt(error_sq)},
                {"noise", std::sqrt(error_sq - model.bias_sq())},
                {"blur", std::sqrt(model.blur_sq)},
                {"truncation", std::sqrt(model.truncation_sq)},
                {"bound", std::sqrt(error_sq + margin_of(goal, model, proposal.hits))},
                {"seconds", proposal.cost.seconds},
                {"bytes", proposal.cost.bytes},
                {"prepare_seconds", proposal.cost.prepare_seconds},
                {"measured", static_cast<bool>(result.estimates.measured[proposal.candidate])}};
    if (proposal.expected) row["expected"] = *proposal.expected;
    return row;
}

Json runs_as_json(std::span<const VerifiedRun> runs) {
    Json all = Json::array();
    for (const VerifiedRun& run : runs)
        all.push_back({{"seed", run.seed},
                       {"hits", run.hits},
                       {"error", run.error},
                       {"worst_share", run.worst_share},
                       {"seconds", run.seconds},
                       {"bytes", run.bytes}});
    return all;
}

Json decision_as_json(const FitResult& result, const Decision& decision, const FitGoal& goal,
                      std::span<const VerifiedRun> verified) {
    const Choice& choice = decision.choice;
    Json entry = {{"reached", choice.reached}, {"sure", decision.doubt.empty()}};
    if (!decision.doubt.empty()) entry["doubt"] = decision.doubt;
    if (!choice.reached) entry["reason"] = choice.reason;
    if (choice.reached || choice.proposal.hits > 0)
        entry[choice.reached ? "choice" : "nearest"] = proposal_as_json(result, choice.proposal, goal);
    if (!verified.empty()) entry["verified"] = runs_as_json(verified);
    return entry;
}

Json rows_of(const FitResult& result, std::span<const Proposal> proposals, const FitGoal& goal) {
    Json rows = Json::array();
    for (const Proposal& proposal : proposals.first(std::min(proposals.size(), rows_of_table)))
        rows.push_back(proposal_as_json(result, proposal, goal));
    return rows;
}

/// Names the quantity that a candidate's value is.
const char* kind_name(CandidateKind kind) {
    switch (kind) {
        case CandidateKind::light_map:
            return "texels";
        case CandidateKind::adaptive_map:
            return "wanted percent";
        case CandidateKind::photon_radius:
            return "radius";
        case CandidateKind::photon_share:
            break;
    }
    return "share";
}

Json pilot_as_json(const FitPlan& plan, const FitResult& result) {
    Json pilot = {{"hits_of_each_half", result.pilot_hits},
                  {"largest_allowed", plan.pilot_hits},
                  {"path_samples_of_each_half", result.truth_samples},
                  {"seconds", result.pilot_seconds},
                  {"best_answers", result.candidates[result.estimates.best].name(result.pilot_hits)}};
    if (!result.lost_light.empty()) pilot["not_found_by_paths"] = result.lost_light;
    if (!result.stopped.empty()) pilot["stopped"] = result.stopped;
    return pilot;
}

/// Formats a row; hits are printed as 3.24e+07 and bytes as 12.3 MB.
std::string row_text(const char* form, const Json& row) {
    const auto percent = [&](const char* part) { return 100 * row[part].get<double>(); };
    return fmt::format(fmt::runtime(form), row["method"].get<std::string>(), row["hits"].get<double>(),
                       percent("error"), percent("noise"), percent("blur"), percent("truncation"),
                       percent("bound"), row["seconds"].get<double>(), row["bytes"].get<double>() / 1e6);
}

constexpr const char* text_row =
    "{:<46} {:>9.3g} {:>7.3g} {:>7.3g} {:>7.3g} {:>10.3g} {:>7.3g} {:>9.3g} {:>9.4g}\n";
constexpr const char* markdown_row =
    "| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.4g} |\n";

/// Says whether the choice is sure, and what was measured.
std::string measured_text(const Json& entry) {
    std::string text;
    if (entry.contains("doubt")) text = fmt::format("not sure: {}", entry["doubt"].get<std::string>());
    if (!entry.contains("verified")) return text;
    text += text.empty() ? "measured: " : "; measured: ";
    bool first = true;
    for (const Json& run : entry["verified"]) {
        text += first ? "" : ", ";
        const double error = run["error"], worst_share = run["worst_share"];
        text +=
            fmt::format("{:.3g} % ({:.3g} % without the worst thousandth of the points; {:.3g} s)",
                        100 * error, 100 * error * std::sqrt(1 - worst_share), run["seconds"].get<double>());
        first = false;
    }
    return text;
}

std::string pilot_text(const Json& document) {
    const Json& pilot = document["pilot"];
    const double target = document["target"];
    const std::string stopped =
        pilot.contains("stopped") ? fmt::format(" ({})", pilot["stopped"].get<std::string>()) : "";
    return fmt::format(
        "{}: target {:g} %, least {}; pilot of 2 x {:.3g} hits and 2 x {} paths a point, seed {}, {:.3g} s{}",
        document["scene"].get<std::string>(), 100 * target, document["least"].get<std::string>(),
        pilot["hits_of_each_half"].get<double>(), pilot["path_samples_of_each_half"].get<std::uint64_t>(),
        document["seed"].get<std::uint64_t>(), pilot["seconds"].get<double>(), stopped);
}

constexpr std::array<std::pair<const char*, const char*>, 2> kinds = {
    {{"light_map", "light map"}, {"photon_map", "photon map"}}};

}  // namespace

Json fit_as_json(const FitPlan& plan, const FitGoal& goal, const common::Scene& scene,
                 const FitResult& result, const FitVerification& verified) {
    Json context = provenance();
    context["threads"] = plan.threads;
    context["settings"] = describe(plan.settings);
    context["lights_and_camera"] = fmt::format("{} {} {}", plan.scene.sky, plan.scene.sun, plan.scene.camera);
    Json document = {{"context", context},
                     {"definition", fit_definition},
                     {"scene", std::filesystem::path(plan.file).stem().string()},
                     {"file", scene.source},
                     {"fingerprint", common::fingerprint(scene)},
                     {"target", goal.target},
                     {"metric", "relative RMS"},
                     {"least", goal.least()},
                     {"max_hits", goal.max_hits},
                     {"margin", goal.margin},
                     {"seed", plan.seed},
                     {"pilot", pilot_as_json(plan, result)},
                     {"light_map", decision_as_json(result, result.light_map, goal, verified.light_map)},
                     {"photon_map", decision_as_json(result, result.photon_map, goal, verified.photon_map)},
                     {"light_maps", rows_of(result, result.light_map.proposals, goal)},
                     {"photon_maps", rows_of(result, result.photon_map.proposals, goal)}};
    if (plan.reference) {
        document["reference"] = plan.reference->string();
        document["reference_error"] = verified.reference_error;
    }
    return document;
}

Json models_as_json(const FitResult& result) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < result.candidates.size(); ++i) {
        if (!result.estimates.model[i]) continue;
        const Candidate& candidate = result.candidates[i];
        const ErrorModel& model = *result.estimates.model[i];
        rows.push_back({{"chain", candidate.chain()},
                        {"kind", kind_name(candidate.kind)},
                        {"value", candidate.value},
                        {"measured", static_cast<bool>(result.estimates.measured[i])},
                        {"pilot_hits", model.pilot_hits},
                        {"noise_sq", model.noise_sq},
                        {"blur_sq", model.blur_sq},
                        {"truncation_sq", model.truncation_sq},
                        {"bias_sq_standard_error", std::sqrt(model.bias_variance)},
                        {"sampling_standard_error", std::sqrt(model.sampling_variance)},
                        {"spread_standard_error", std::sqrt(model.spread_variance)},
                        {"noise_standard_error", std::sqrt(model.noise_variance)}});
    }
    return rows;
}

std::string fit_as_text(const Json& document) {
    std::string text =
        pilot_text(document) + fmt::format("\n\n{:<46} {:>9} {:>7} {:>7} {:>7} {:>10} {:>7} {:>9} {:>9}\n",
                                           "", "hits", "error %", "noise", "blur", "truncation", "bound",
                                           "seconds", "MB");
    for (const auto& [key, name] : kinds) {
        const Json& entry = document[key];
        if (entry["reached"].get<bool>())
            text += row_text(text_row, entry["choice"]);
        else
            text += fmt::format("{}: out of reach: {}\n", name, entry["reason"].get<std::string>());
        if (const std::string measured = measured_text(entry); !measured.empty())
            text += fmt::format("  {}\n", measured);
    }
    if (document.contains("explanation"))
        text += fmt::format("\n{}", explanation_text(document["explanation"], rows_of_table));
    return text;
}

std::string fit_as_markdown(const Json& document) {
    std::string text = fmt::format("# Settings for {}\n\n{}.\n\n{}\n", document["scene"].get<std::string>(),
                                   pilot_text(document), fit_definition);
    for (const auto& [key, name] : kinds) {
        const Json& entry = document[key];
        text += fmt::format("\n## Best {}\n\n", name);
        if (entry["reached"].get<bool>())
            text += fmt::format("{} with {:.3g} hits.\n", entry["choice"]["method"].get<std::string>(),
                                entry["choice"]["hits"].get<double>());
        else
            text += fmt::format("Out of reach: {}.\n", entry["reason"].get<std::string>());
        if (const std::string measured = measured_text(entry); !measured.empty())
            text += fmt::format("\n{}\n", measured);
        const Json& rows = document[std::string(key) + "s"];
        if (rows.empty()) continue;
        text +=
            "\n| method | hits | error % | noise | blur | truncation | bound | seconds | MB |\n"
            "|---|---|---|---|---|---|---|---|---|\n";
        for (const Json& row : rows) text += row_text(markdown_row, row);
    }
    if (document.contains("explanation"))
        text += fmt::format("\n## Why this light map\n\n{}\n\n{}\n![](explanation.png)\n", explanation_words,
                            explanation_text(document["explanation"], rows_of_table));
    return text;
}

}  // namespace bench::fit
