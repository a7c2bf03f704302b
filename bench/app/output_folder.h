// The folder that a command's results go to.
#pragma once

#include <filesystem>
#include <string>

namespace bench {

/// Makes the folder where it is missing and makes sure that files can be written there. Throws InputError,
/// naming `option`, where that fails.
void prepare_output_folder(const std::string& option, const std::filesystem::path& folder);

/// Writes `text` under a temporary name and moves it to `file`: there is never half a file. Throws
/// InputError.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace bench
