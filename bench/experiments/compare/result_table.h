// compare.json and compare.csv while they grow.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/experiments/compare/compare_plan.h"

namespace bench::compare {

/// Begins with what an earlier run of the same build, machine, seed and settings has left in the folder, so
/// that a comparison can be stopped and gone on with, or extended by scenes and sizes.
class ResultTable {
  public:
    explicit ResultTable(const ComparePlan& plan);

    /// Forgets rows of a scene of the same name that differs from the one with this fingerprint.
    void keep_one_version_of(const std::string& scene, const std::string& fingerprint);

    /// Whether the row has been measured already, by as many repetitions as are asked for now or more;
    /// skipped ones are judged anew.
    [[nodiscard]] bool has(const std::string& scene, const std::string& method, std::uint64_t hits) const;

    /// Appends the rows, in the place of those they repeat, and writes both files anew: what is finished
    /// survives whatever comes.
    void add(const std::vector<nlohmann::ordered_json>& rows);

    [[nodiscard]] const nlohmann::ordered_json& rows() const { return document_["rows"]; }

  private:
    std::filesystem::path folder_;
    std::size_t repetitions_;  ///< asked for; a size may get fewer, for its time
    nlohmann::ordered_json document_;
};

}  // namespace bench::compare
