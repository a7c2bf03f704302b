// The folder that a command's results go to.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// What a command makes in its folder, by name.
struct ResultNames {
    std::string table;                 ///< JSON with a "context": whose it is, the other files are as well
    std::vector<std::string> files;    ///< beside it
    std::vector<std::string> folders;  ///< filled with files of many names
};

/// Throws InputError, naming `option`, where results in `folder` would take the place of something that no
/// earlier run has left there or, by whatever path or link, of one of `inputs`. Makes nothing.
void check_results(const std::string& option, const std::filesystem::path& folder, const ResultNames& names,
                   std::span<const std::filesystem::path> inputs);

/// Makes the folder where it is missing and makes sure that files can be written there. Throws InputError,
/// naming `option`, where that fails.
void prepare_output_folder(const std::string& option, const std::filesystem::path& folder);

/// Writes `text` under a temporary name and moves it to `file`: there is never half a file. Throws
/// InputError.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace bench
