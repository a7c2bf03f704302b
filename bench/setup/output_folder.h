// The folder of a command's results.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// The names of what a command writes into its folder.
struct ResultNames {
    std::string table;                 ///< JSON with a "context", which identifies the owner of all files
    std::vector<std::string> files;    ///< the files beside it
    std::vector<std::string> folders;  ///< filled with files of varying names
};

/// Throws InputError, naming `option`, where results in `folder` would overwrite something that no earlier
/// run has left there, or, by any path or link, one of `inputs`. Makes nothing.
void check_results(const std::string& option, const std::filesystem::path& folder, const ResultNames& names,
                   std::span<const std::filesystem::path> inputs);

/// Makes the folder if it is missing, and checks that files can be written there. Throws InputError, naming
/// `option`, if that fails.
void prepare_output_folder(const std::string& option, const std::filesystem::path& folder);

/// Writes `text` to a temporary file and renames it to `file`, so that the file is never incomplete. Throws
/// InputError.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace bench
