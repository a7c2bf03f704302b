// Checks before long work that its results can be written, and writes them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace common {

/// Returns whether a file can be created in the folder. Creates one and removes it at once, as permissions
/// alone allow root to write even where nothing can be written.
[[nodiscard]] bool is_writable_folder(const std::filesystem::path& folder);

/// Returns the temporary path where this process assembles a file: beside it, hidden, with its extension.
[[nodiscard]] std::filesystem::path temporary_beside(const std::filesystem::path& file);

/// Throws InputError, naming `option`, if `file` cannot be written: its folder is missing or not writable,
/// its name is too long, or it exists and is not a regular file.
void check_output_file(const std::string& option, const std::filesystem::path& file);

/// Throws InputError, naming `option`, if `output` is the same file as one of `inputs`, by any path or link:
/// results never replace their inputs. A path without a file matches none.
void refuse_input_as_output(const std::string& option, const std::filesystem::path& output,
                            std::span<const std::filesystem::path> inputs);

/// Writes under a temporary name, flushes to the disk and renames to `file`. So `file` is never incomplete,
/// and a failed write leaves nothing behind. Throws InputError.
void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace common
