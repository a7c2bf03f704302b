#include "bench/experiments/study/study_table.h"

#include <fmt/format.h>

#include "bench/setup/earlier_rows.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/provenance.h"
#include "common/core/input_error.h"
#include "common/core/standard_streams.h"

namespace bench::study {
namespace {

using Json = nlohmann::ordered_json;

Json context_of(const StudyPlan& plan) {
    Json context = provenance();
    context["threads"] = plan.threads;
    context["settings"] = describe(plan.settings);
    context["lights_and_camera"] = fmt::format("{} {} {}", plan.scene.sky, plan.scene.sun, plan.scene.camera);
    return context;
}

}  // namespace

StudyTable::Key StudyTable::key_of(const Json& row) {
    return {row["scene"], row["method"], row["hits_asked"], row["seed"]};
}

StudyTable::StudyTable(const StudyPlan& plan) : file_(plan.out / "study.json") {
    document_ = {{"context", context_of(plan)}, {"scenes", Json::object()}, {"rows", Json::array()}};
    const EarlierRows earlier = read_earlier_rows(file_, document_["context"]);
    if (!earlier.found) return;
    if (!earlier.same_context && plan.anew) return;
    if (!earlier.same_context)
        throw common::InputError(
            fmt::format("{} is of another build, machine or setting; --anew begins again in its "
                        "place, or give another --out",
                        file_.string()));
    document_["context"]["date"] = earlier.document["context"]["date"];  // of its first rows
    if (earlier.document.contains("scenes")) document_["scenes"] = earlier.document["scenes"];
    document_["rows"] = earlier.document["rows"];
    for (const Json& row : document_["rows"])
        if (!row.contains("skipped")) present_.insert(key_of(row));
    common::say(fmt::format("study: {} rows in {} are of this build and settings and are kept", row_count(),
                            file_.string()));
}

std::vector<Contender> StudyTable::missing(const std::string& scene, const std::vector<Contender>& methods,
                                           std::uint64_t hits, std::uint64_t seed) const {
    std::vector<Contender> missing;
    for (const Contender& method : methods)
        if (!present_.contains({scene, method.name, hits, seed})) missing.push_back(method);
    return missing;
}

bool StudyTable::is_missing_any(const std::string& scene, const std::vector<Contender>& methods,
                                std::uint64_t hits, std::uint64_t seeds) const {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        if (!missing(scene, methods, hits, seed).empty()) return true;
    return false;
}

void StudyTable::describe_scene(const std::string& name, const Json& facts) {
    Json& known = document_["scenes"][name];
    for (const char* key : {"fingerprint", "width", "height", "points"})
        if (known.contains(key) && known[key] != facts[key])
            throw common::InputError(fmt::format(
                "{}: the rows of {} are for another {}: {} there, {} asked for; give another --out",
                file_.string(), name, key, known[key].dump(), facts[key].dump()));
    known = facts;
}

void StudyTable::add(const std::vector<Json>& rows) {
    Json& all = document_["rows"];
    for (const Json& row : rows) {
        const auto skipped_before = std::find_if(all.begin(), all.end(), [&](const Json& r) {
            return r.contains("skipped") && key_of(r) == key_of(row);
        });
        if (skipped_before != all.end()) all.erase(skipped_before);
        all.push_back(row);
        if (!row.contains("skipped")) present_.insert(key_of(row));
    }
    write();
}

void StudyTable::change_rows(const std::string& scene, const std::function<void(Json&)>& change) {
    for (Json& row : document_["rows"])
        if (row["scene"] == scene && !row.contains("skipped")) change(row);
    write();
}

void StudyTable::write() const {
    write_text(file_, document_.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace bench::study
