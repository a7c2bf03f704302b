#include "bench/compare/result_table.h"

#include "bench/app/provenance.h"
#include "bench/compare/output_folder.h"
#include "bench/compare/row.h"

namespace bench {

ResultTable::ResultTable(const ComparePlan& plan) : folder_(plan.out) {
    document_["context"] = provenance();
    document_["context"]["seed"] = plan.seed;
    document_["context"]["threads"] = plan.threads;
    document_["context"]["settings"] = describe(plan.settings);
    document_["context"]["max_memory_bytes"] = plan.max_bytes;
    document_["rows"] = nlohmann::ordered_json::array();
}

void ResultTable::add(const std::vector<nlohmann::ordered_json>& rows) {
    for (const auto& row : rows) document_["rows"].push_back(row);
    write_text(folder_ / "compare.json", document_.dump(2) + "\n");
    write_text(folder_ / "compare.csv", rows_as_csv(document_["rows"]));
}

}  // namespace bench
