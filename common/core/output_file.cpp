#include "common/core/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "common/core/input_error.h"

namespace common {

namespace fs = std::filesystem;

bool is_writable_folder(const fs::path& folder) {
    std::string name = (folder / ".shlmbench-XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) return false;
    close(file);
    unlink(name.c_str());
    return true;
}

void check_output_file(const std::string& option, const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;  // a path that cannot be looked at is no folder either
    if (!fs::is_directory(folder, ignored))
        throw InputError(fmt::format("{}: there is no folder {}", option, folder.string()));
    if (!is_writable_folder(folder))
        throw InputError(fmt::format("{}: {} cannot be written to", option, folder.string()));
    if (fs::is_directory(file, ignored))
        throw InputError(fmt::format("{}: {} is a folder", option, file.string()));
}

}  // namespace common
