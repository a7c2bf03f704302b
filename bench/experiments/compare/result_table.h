// compare.json and compare.csv, which are updated while a comparison runs.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/experiments/compare/compare_plan.h"

namespace bench::compare {

/// Begins with the rows in the folder that the same build, machine, seed and settings have produced. A
/// comparison can thus be stopped and continued, or extended by scenes and sizes.
class ResultTable {
  public:
    explicit ResultTable(const ComparePlan& plan);

    /// Removes the rows of a scene of the same name whose fingerprint differs.
    void keep_one_version_of(const std::string& scene, const std::string& fingerprint);

    /// Returns whether the row exists with at least as many repetitions as are now asked for. Skipped rows do
    /// not count, and are tried again.
    [[nodiscard]] bool has(const std::string& scene, const std::string& method, std::uint64_t hits) const;

    /// Appends the rows, replacing earlier ones of the same key, and rewrites both files. Finished rows thus
    /// survive any failure.
    void add(const std::vector<nlohmann::ordered_json>& rows);

    [[nodiscard]] const nlohmann::ordered_json& rows() const { return document_["rows"]; }

  private:
    std::filesystem::path folder_;
    std::size_t repetitions_;  ///< as asked for; the time limit may allow a size fewer
    nlohmann::ordered_json document_;
};

}  // namespace bench::compare
