#include "common/core/writable_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

namespace common {

bool is_writable_folder(const std::filesystem::path& folder) {
    std::string name = (folder / ".shlmbench-XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) return false;
    close(file);
    unlink(name.c_str());
    return true;
}

}  // namespace common
