#include "bench/experiments/fit/explanation_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/contenders/light_map.h"

namespace bench::fit {
namespace {

using Json = nlohmann::ordered_json;

/// What the pixels that show one instance see.
struct Seen {
    std::map<std::string, std::size_t> pixels_by_kind;
    std::vector<float> width;
};

std::map<std::uint32_t, Seen> seen_by_instance(const Explanation& explanation) {
    std::map<std::uint32_t, Seen> seen;
    for (const std::optional<SeenBlock>& block : explanation.pixel) {
        if (!block) continue;
        Seen& one = seen[block->instance];
        ++one.pixels_by_kind[block->kind];
        one.width.push_back(block->width);
    }
    return seen;
}

/// Returns the fraction of the instance's pixels for each kind of block, and the median width of the blocks
/// they see.
Json blocks_as_json(Seen& seen) {
    Json kinds = Json::object();
    for (const auto& [kind, pixels] : seen.pixels_by_kind)
        kinds[kind] = static_cast<double>(pixels) / static_cast<double>(seen.width.size());
    const auto middle = seen.width.begin() + static_cast<std::ptrdiff_t>(seen.width.size() / 2);
    std::nth_element(seen.width.begin(), middle, seen.width.end());
    return {{"kinds", kinds}, {"median_width", *middle}};
}

Json surface_as_json(const common::Scene& scene, std::uint32_t instance, Seen& seen) {
    const common::MeshInstance& mesh = scene.instance[instance];
    Json row = {
        {"instance", instance}, {"name", mesh.name}, {"material", scene.material[mesh.material].name}};
    if (!seen.width.empty()) row["blocks"] = blocks_as_json(seen);
    return row;
}

std::string kinds_text(const Json& kinds) {
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [kind, share] : kinds.items()) sorted.emplace_back(share.get<double>(), kind);
    std::sort(sorted.rbegin(), sorted.rend());
    std::string text;
    for (const auto& [share, kind] : sorted) {
        if (share < 0.005) continue;
        text += text.empty() ? "" : ", ";
        text += share > 0.995 ? kind : fmt::format("{} {:.0f} %", kind, 100 * share);
    }
    return text;
}

std::string row_text(const Json& row) {
    const auto percent = [&](const char* key) {
        return row.contains(key) ? fmt::format("{:.3g}", 100 * row[key].get<double>()) : std::string("-");
    };
    const Json empty = {{"kinds", Json::object()}, {"median_width", 0}};
    const Json& blocks = row.contains("blocks") ? row["blocks"] : empty;
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {:.3g} |\n", row["name"].get<std::string>(),
                       row["material"].get<std::string>(), percent("points"), percent("error_share"),
                       percent("error"), percent("noise"), percent("bias"), kinds_text(blocks["kinds"]),
                       blocks["median_width"].get<double>());
}

}  // namespace

Json explanation_as_json(const Explanation& explanation, const common::Scene& scene) {
    std::map<std::uint32_t, Seen> seen = seen_by_instance(explanation);
    Json rows = Json::array();
    double whole = 0;
    for (const SurfaceError& surface : explanation.surfaces)
        whole += surface.noise_sq + std::max(surface.bias_sq, 0.0);
    for (const SurfaceError& surface : explanation.surfaces) {
        const double bias_sq = std::max(surface.bias_sq, 0.0), error_sq = surface.noise_sq + bias_sq;
        Json row = surface_as_json(scene, surface.instance, seen[surface.instance]);
        row["points"] = surface.points;
        row["error_share"] = whole > 0 ? error_sq / whole : 0;
        row["error"] = std::sqrt(error_sq / surface.points);
        row["noise"] = std::sqrt(surface.noise_sq / surface.points);
        row["bias"] = std::sqrt(bias_sq / surface.points);
        rows.push_back(row);
    }
    if (explanation.surfaces.empty())
        for (auto& [instance, blocks] : seen) rows.push_back(surface_as_json(scene, instance, blocks));
    return rows;
}

/// Returns a colour for each thing that a block may keep, ordered by the order of the harmonics that are
/// summed for it.
Json colours_of_kinds() {
    std::vector<const LightBasis*> bases;
    for (const auto& [place, basis] : light_bases()) bases.push_back(&basis);
    std::stable_sort(bases.begin(), bases.end(),
                     [](const LightBasis* a, const LightBasis* b) { return a->order < b->order; });
    Json colours = {{"dark", "#202020"}, {"flat", "#9ecae1"}};
    for (const LightBasis* basis : bases) colours[basis->name] = basis->style.colour;
    return colours;
}

Json picture_as_json(const Explanation& explanation, const Json& fit) {
    const Json& entry = fit["light_map"];
    Json kinds = Json::array(), widths = Json::array();
    for (const std::optional<SeenBlock>& block : explanation.pixel) {
        kinds.push_back(block ? block->kind : "");
        widths.push_back(block ? std::round(block->width * 1e4f) / 1e4f : 0.0f);
    }
    return {{"context", fit["context"]},
            {"scene", fit["scene"]},
            {"target", fit["target"]},
            {"metric", fit["metric"]},
            {"seed", fit["seed"]},
            {"reached", entry["reached"]},
            {"choice", entry[entry["reached"].get<bool>() ? "choice" : "nearest"]},
            {"width", explanation.width},
            {"height", explanation.height},
            {"kind", kinds},
            {"colours", colours_of_kinds()},
            {"block_width", widths}};
}

std::string explanation_text(const Json& surfaces, std::size_t rows) {
    std::string text =
        "| surface | material | points % | of the squared error % | error % there | noise | bias | keeps | "
        "median block |\n|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < std::min(rows, surfaces.size()); ++i) text += row_text(surfaces[i]);
    if (surfaces.size() > rows)
        text += fmt::format("\n{} more surfaces are in fit.json.\n", surfaces.size() - rows);
    return text;
}

}  // namespace bench::fit
