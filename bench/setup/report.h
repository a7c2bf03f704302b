// Runs bench/report, which makes texts and charts of results.
#pragma once

#include <filesystem>
#include <string>

namespace bench {

/// Runs report `name` of bench/report on a folder of results. Returns false if it fails; it says why on
/// stderr.
[[nodiscard]] bool write_report(const std::string& name, const std::filesystem::path& folder);

}  // namespace bench
