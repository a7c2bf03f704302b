// Whether results can be put somewhere, asked before they are worked for, and how they are put there.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace common {

/// Tries it, with a file that is gone again at once: permissions alone say yes to root where nothing can be
/// written.
[[nodiscard]] bool is_writable_folder(const std::filesystem::path& folder);

/// Where this process puts a file together before it gets its name: beside it, hidden, with its extension.
[[nodiscard]] std::filesystem::path temporary_beside(const std::filesystem::path& file);

/// Throws InputError, naming `option`, where `file` cannot be written: its folder is missing or refuses it,
/// its name is too long, or what has that name is no regular file.
void check_output_file(const std::string& option, const std::filesystem::path& file);

/// Throws InputError, naming `option`, where `output` is one of `inputs`, by whatever path or link: results
/// never replace what they are made from. Paths without a file are nobody's.
void refuse_input_as_output(const std::string& option, const std::filesystem::path& output,
                            std::span<const std::filesystem::path> inputs);

/// Writes under a temporary name, down to the disk, and moves it to `file`: there is never half a file, and
/// nothing is left of one that failed. Throws InputError.
void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace common
