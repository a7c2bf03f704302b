#include "bench/compare/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "bench/app/provenance.h"
#include "bench/compare/output_folder.h"
#include "bench/compare/row.h"

namespace bench {
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

/// Whether rows measured under `earlier` can stand beside rows measured under `now`: all but the date must
/// agree, the time when the program was built included.
bool is_same_context(Json earlier, Json now) {
    earlier.erase("date");
    now.erase("date");
    return earlier == now;
}

/// The rows in `file` that can be kept; empty where there are none. Skipped ones are judged anew, and ones
/// with fewer repetitions than were asked for, because the user ended them, measured anew.
Json earlier_rows(const std::filesystem::path& file, const Json& context) {
    std::ifstream in(file);
    const Json document = Json::parse(in, nullptr, false);
    if (!document.is_object() || !document.contains("context") || !document.contains("rows"))
        return Json::array();
    if (!is_same_context(document["context"], context)) {
        fmt::print(stderr, "compare: {} is of another build, machine or setting and is written anew\n",
                   file.string());
        return Json::array();
    }
    Json kept = Json::array();
    for (const Json& row : document["rows"])
        if (!row.contains("skipped") && !row.contains("interrupted")) kept.push_back(row);
    fmt::print(stderr, "compare: {} rows in {} are of this build and settings and are kept\n", kept.size(),
               file.string());
    return kept;
}

}  // namespace

ResultTable::ResultTable(const ComparePlan& plan) : folder_(plan.out) {
    document_["context"] = context_of(plan);
    document_["rows"] = earlier_rows(folder_ / "compare.json", document_["context"]);
}

bool ResultTable::has(const std::string& scene, const std::string& method, std::uint64_t hits) const {
    return std::any_of(rows().begin(), rows().end(), [&](const Json& row) {
        return row["scene"] == scene && row["method"] == method && row["hits_asked"] == hits;
    });
}

void ResultTable::add(const std::vector<Json>& rows) {
    for (const Json& row : rows) document_["rows"].push_back(row);
    write_text(folder_ / "compare.json", document_.dump(2) + "\n");
    write_text(folder_ / "compare.csv", rows_as_csv(document_["rows"]));
}

}  // namespace bench
