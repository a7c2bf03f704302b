// compare.json and compare.csv while they grow.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/compare/compare_plan.h"

namespace bench {

class ResultTable {
  public:
    explicit ResultTable(const ComparePlan& plan);

    /// Appends the rows and writes both files anew: what is finished survives whatever comes.
    void add(const std::vector<nlohmann::ordered_json>& rows);

    [[nodiscard]] const nlohmann::ordered_json& rows() const { return document_["rows"]; }

  private:
    std::filesystem::path folder_;
    nlohmann::ordered_json document_;
};

}  // namespace bench
