#include "bench/experiments/stability/stability_table.h"

#include <fmt/format.h>

#include "bench/experiments/stability/verdict.h"

namespace bench::stability {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(Expected expected) {
    switch (expected) {
        case Expected::at_most:
            return "at most";
        case Expected::shown:
            return "shown";
        case Expected::equal:
            break;
    }
    return "equal";
}

Json curve_as_json(const StabilityCurve& curve, double false_alarms) {
    Json points = Json::array();
    for (const StabilityPoint& point : curve.points) {
        const PointVerdict verdict = judge(point, curve.expected, false_alarms);
        points.push_back({{"at", point.at},
                          {"predicted", point.predicted},
                          {"mean", verdict.mean},
                          {"confidence", verdict.confidence},
                          {"band", verdict.band},
                          {"passed", verdict.passed}});
    }
    return {{"name", curve.name}, {"expected", name_of(curve.expected)}, {"points", points}};
}

/// Returns the largest deviation of the row's points relative to their bands; above 1, a point fails.
double largest_share_of_band(const Json& row) {
    double largest = 0;
    for (const Json& curve : row["curves"]) {
        if (curve["expected"] == "shown") continue;
        for (const Json& point : curve["points"]) {
            if (!point["mean"].is_number()) return std::numeric_limits<double>::infinity();
            double off = point["mean"].get<double>() - point["predicted"].get<double>();
            if (curve["expected"] == "equal") off = std::abs(off);
            if (off > 0) largest = std::max(largest, off / point["band"].get<double>());
        }
    }
    return largest;
}

std::size_t count_judged(const Json& row) {
    std::size_t points = 0;
    for (const Json& curve : row["curves"])
        if (curve["expected"] != "shown") points += curve["points"].size();
    return points;
}

std::string number_text(const Json& number) {
    return number.is_number() ? fmt::format("{:.5g}", number.get<double>()) : "not finite";
}

std::string verdict_text(const Json& row) {
    return row["passed"].get<bool>() ? "as predicted" : "**not as predicted**";
}

std::string case_as_markdown(const Json& row) {
    const auto text = [&](const char* key) { return row[key].get<std::string>(); };
    std::string out =
        fmt::format("\n## {}: {}\n\n{}\n\n- Scene: {}\n- Theory: {}\n- For the user: {}\n\n", text("name"),
                    verdict_text(row), text("purpose"), text("scene"), text("theory"), text("advice"));
    out += fmt::format("![](charts/{}.png)\n\n", text("name"));
    if (row["picture"].get<bool>()) out += fmt::format("![](images/{}.png)\n\n", text("name"));
    out += fmt::format("| curve | {} | predicted | measured: {} | band | |\n|---|---|---|---|---|---|\n",
                       text("swept"), text("measured"));
    for (const Json& curve : row["curves"])
        for (const Json& point : curve["points"])
            out += fmt::format("| {} | {} | {}{} | {} | {} | {} |\n", curve["name"].get<std::string>(),
                               number_text(point["at"]), curve["expected"] == "at most" ? "at most " : "",
                               number_text(point["predicted"]), number_text(point["mean"]),
                               curve["expected"] == "shown" ? "" : "± " + number_text(point["band"]),
                               curve["expected"] == "shown"  ? "shown"
                               : point["passed"].get<bool>() ? "inside"
                                                             : "**outside**");
    return out;
}

}  // namespace

Json case_as_json(const StabilityCase& stability_case, std::span<const StabilityCurve> curves, bool full,
                  std::size_t seeds, double seconds) {
    const std::size_t cases = stability_cases().size();
    const double false_alarms = false_alarms_per_point(curves, cases);
    Json list = Json::array();
    for (const StabilityCurve& curve : curves) list.push_back(curve_as_json(curve, false_alarms));
    return {{"name", stability_case.name},
            {"purpose", stability_case.purpose},
            {"scene", stability_case.scene},
            {"swept", stability_case.swept},
            {"measured", stability_case.measured},
            {"theory", stability_case.theory},
            {"advice", stability_case.advice},
            {"logarithmic_swept", stability_case.logarithmic_swept},
            {"logarithmic_measured", stability_case.logarithmic_measured},
            {"picture", stability_case.picture != nullptr},
            {"form", full ? "full" : "short"},
            {"seeds", seeds},
            {"false_alarms_per_point", false_alarms},
            {"seconds", seconds},
            {"passed", passes(curves, cases)},
            {"curves", list}};
}

std::string cases_as_text(const Json& rows) {
    std::string text =
        fmt::format("{:<22} {:>6} {:>14} {:>8}  {}\n", "case", "points", "largest / band", "seconds", "");
    for (const Json& row : rows)
        text += fmt::format("{:<22} {:>6} {:>14.2f} {:>8.1f}  {}\n", row["name"].get<std::string>(),
                            count_judged(row), largest_share_of_band(row), row["seconds"].get<double>(),
                            row["passed"].get<bool>() ? "as predicted" : "NOT AS PREDICTED");
    return text;
}

std::string cases_as_markdown(const Json& document) {
    const Json& context = document["context"];
    std::string text = fmt::format(
        "# Stability where methods fail\n\n"
        "Each case sweeps one parameter of a small scene and holds both methods to what theory says. A point "
        "is "
        "inside if its mean over the seeds is within the band around the prediction: what theory itself "
        "leaves "
        "open, and chance, by Student's t over the seeds, at a level that lets all cases together fail by "
        "accident once in {:g} runs. Confidences in the charts are of 95 %. Seeds 1 to {}, {} form.\n\n"
        "{}, {}, Embree {}, commit {}.\n\n"
        "| case | judged points | largest deviation / band | verdict |\n|---|---|---|---|\n",
        1 / family_false_alarms, document["rows"][0]["seeds"].get<std::size_t>(),
        document["rows"][0]["form"].get<std::string>(), context["machine"].get<std::string>(),
        context["compiler"].get<std::string>(), context["libraries"]["embree"].get<std::string>(),
        context["commit"].get<std::string>());
    for (const Json& row : document["rows"])
        text += fmt::format("| [{}](#{}) | {} | {:.2f} | {} |\n", row["name"].get<std::string>(),
                            row["name"].get<std::string>(), count_judged(row), largest_share_of_band(row),
                            verdict_text(row));
    for (const Json& row : document["rows"]) text += case_as_markdown(row);
    return text;
}

}  // namespace bench::stability
