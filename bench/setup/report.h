// The words and charts that bench/report makes of results.
#pragma once

#include <filesystem>
#include <string>

namespace bench {

/// Report `name` of bench/report, of a folder of results. False where it failed; it says why on stderr.
[[nodiscard]] bool write_report(const std::string& name, const std::filesystem::path& folder);

}  // namespace bench
