#include "bench/compare/result_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/app/earlier_rows.h"
#include "bench/app/output_folder.h"
#include "bench/app/provenance.h"
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

/// The rows in `file` that can be kept; empty where there are none. Skipped ones are judged anew, and ones
/// with fewer repetitions than were asked for, because the user ended them, measured anew.
Json earlier_rows(const std::filesystem::path& file, const Json& context) {
    const EarlierRows earlier = read_earlier_rows(file, context);
    if (!earlier.found) return Json::array();
    if (!earlier.same_context) {
        fmt::print(stderr, "compare: {} is of another build, machine or setting and is written anew\n",
                   file.string());
        return Json::array();
    }
    Json kept = Json::array();
    for (const Json& row : earlier.document["rows"])
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
