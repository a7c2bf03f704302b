// study.json, which is updated while a study runs.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "bench/experiments/study/study_plan.h"

namespace bench::study {

/// Begins with the rows that an earlier run has left in the folder. A study can thus be stopped and
/// continued, or extended by scenes, methods, sizes and seeds.
class StudyTable {
  public:
    /// Throws InputError where the folder has a study of another build, machine or setting, so that hours of
    /// work are not overwritten.
    explicit StudyTable(const StudyPlan& plan);

    /// Returns the methods without a row. Skipped ones count as missing and are tried again.
    [[nodiscard]] std::vector<Contender> missing(const std::string& scene,
                                                 const std::vector<Contender>& methods, std::uint64_t hits,
                                                 std::uint64_t seed) const;
    [[nodiscard]] bool is_missing_any(const std::string& scene, const std::vector<Contender>& methods,
                                      std::uint64_t hits, std::uint64_t seeds) const;

    /// Throws InputError where the scene has rows for other points or another version of it, as they cannot
    /// be compared.
    void describe_scene(const std::string& name, const nlohmann::ordered_json& facts);

    /// Appends the rows and rewrites the file, so that finished rows survive any failure.
    void add(const std::vector<nlohmann::ordered_json>& rows);

    /// Calls `change` with every measured row of a scene, and rewrites the file.
    void change_rows(const std::string& scene, const std::function<void(nlohmann::ordered_json&)>& change);

    [[nodiscard]] std::size_t row_count() const { return document_["rows"].size(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  private:
    using Key = std::tuple<std::string, std::string, std::uint64_t, std::uint64_t>;

    [[nodiscard]] static Key key_of(const nlohmann::ordered_json& row);
    void write() const;

    std::filesystem::path file_;
    nlohmann::ordered_json document_;
    std::set<Key> present_;  ///< scene, method, hits asked, seed
};

}  // namespace bench::study
