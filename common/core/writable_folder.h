// Whether results can be put somewhere, asked before they are worked for.
#pragma once

#include <filesystem>

namespace common {

/// Tries it, with a file that is gone again at once: permissions alone say yes to root where nothing can be
/// written.
[[nodiscard]] bool is_writable_folder(const std::filesystem::path& folder);

}  // namespace common
