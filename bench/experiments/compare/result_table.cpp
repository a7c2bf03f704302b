#include "bench/experiments/compare/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "bench/experiments/compare/row.h"
#include "bench/setup/earlier_rows.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/provenance.h"
#include "common/core/standard_streams.h"

namespace bench::compare {
namespace {

using Json = nlohmann::ordered_json;

Json context_of(const ComparePlan& plan) {
    Json context = provenance();
    context["seed"] = plan.seed;
    context["threads"] = plan.threads;
    context["settings"] = describe(plan.settings);
    context["lights_and_camera"] = fmt::format("{} {} {}", plan.scene.sky, plan.scene.sun, plan.scene.camera);
    return context;
}

/// Returns the rows in `file` that can be kept; empty if there are none.
Json earlier_rows(const std::filesystem::path& file, const Json& context) {
    const EarlierRows earlier = read_earlier_rows(file, context);
    if (!earlier.found) return Json::array();
    if (!earlier.same_context) {
        common::say(fmt::format("compare: {} is of another build, machine or setting and is written anew",
                                file.string()));
        return Json::array();
    }
    const Json& rows = earlier.document["rows"];
    common::say(fmt::format("compare: {} rows in {} are of this build and settings and are kept", rows.size(),
                            file.string()));
    return rows;
}

/// Returns what identifies a row: a new row with the same key replaces it.
auto key_of(const Json& row) {
    return std::tuple(row["scene"].get<std::string>(), row["method"].get<std::string>(),
                      row["hits_asked"].get<std::uint64_t>());
}

void erase_rows(Json& rows, const std::function<bool(const Json&)>& unwanted) {
    for (auto row = rows.begin(); row != rows.end();) row = unwanted(*row) ? rows.erase(row) : std::next(row);
}

}  // namespace

ResultTable::ResultTable(const ComparePlan& plan) : folder_(plan.out), repetitions_(plan.repetitions) {
    document_["context"] = context_of(plan);
    document_["rows"] = earlier_rows(folder_ / "compare.json", document_["context"]);
}

void ResultTable::keep_one_version_of(const std::string& scene, const std::string& fingerprint) {
    erase_rows(document_["rows"],
               [&](const Json& row) { return row["scene"] == scene && row["fingerprint"] != fingerprint; });
}

bool ResultTable::has(const std::string& scene, const std::string& method, std::uint64_t hits) const {
    return std::any_of(rows().begin(), rows().end(), [&](const Json& row) {
        return key_of(row) == std::tuple(scene, method, hits) &&
               row.value("repetitions_asked", 0u) >= repetitions_ && !row.contains("skipped") &&
               !row.contains("interrupted");
    });
}

void ResultTable::add(const std::vector<Json>& rows) {
    for (Json row : rows) {
        erase_rows(document_["rows"], [&](const Json& other) { return key_of(other) == key_of(row); });
        row["repetitions_asked"] = repetitions_;
        document_["rows"].push_back(std::move(row));
    }
    write_text(folder_ / "compare.json",
               document_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    write_text(folder_ / "compare.csv", rows_as_csv(document_["rows"]));
}

}  // namespace bench::compare
