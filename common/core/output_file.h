// Whether results can be put somewhere, asked before they are worked for.
#pragma once

#include <filesystem>
#include <string>

namespace common {

/// Tries it, with a file that is gone again at once: permissions alone say yes to root where nothing can be
/// written.
[[nodiscard]] bool is_writable_folder(const std::filesystem::path& folder);

/// Throws InputError, naming `option`, where `file` cannot be written: its folder is missing or refuses it,
/// or it is a folder itself.
void check_output_file(const std::string& option, const std::filesystem::path& file);

}  // namespace common
