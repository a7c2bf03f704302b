// The project's own Python scripts.
#pragma once

#include <filesystem>
#include <string>

namespace bench {

/// Runs `script`, a path in the source tree, on a folder of results. False where it failed; it says why on
/// stderr.
[[nodiscard]] bool run_python(const std::string& script, const std::filesystem::path& folder);

}  // namespace bench
