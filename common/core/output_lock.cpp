#include "common/core/output_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "common/core/input_error.h"

namespace common {
namespace {

/// Returns whether the path still names the open file, as the previous holder removes it when it ends.
bool is_still_there(int descriptor, const std::filesystem::path& path) {
    struct stat opened {
    }, found{};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &found) == 0 &&
           opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

}  // namespace

OutputLock::OutputLock(const std::string& option, const std::filesystem::path& file)
    : path_(file.string() + ".lock") {
    do {
        if (descriptor_ >= 0) close(descriptor_);
        descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0)
            throw InputError(
                fmt::format("{}: {} cannot be made: {}", option, path_.string(), std::strerror(errno)));
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            close(descriptor_);
            throw InputError(fmt::format("{}: another run is writing {}", option, file.string()));
        }
    } while (!is_still_there(descriptor_, path_));
}

OutputLock::~OutputLock() {
    struct stat opened {};
    if (fstat(descriptor_, &opened) == 0 && opened.st_size == 0) unlink(path_.c_str());
    close(descriptor_);
}

}  // namespace common
