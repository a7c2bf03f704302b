#include "common/core/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "common/core/input_error.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// Returns 0 if a file of this name can be created, else errno. Removes the file at once.
int trouble_with_making(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0) return errno == EEXIST ? 0 : errno;  // left by an earlier process with the same id
    close(descriptor);
    unlink(file.c_str());
    return 0;
}

/// Returns 0 or errno.
int write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written == 0 ? EIO : errno;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

}  // namespace

bool is_writable_folder(const fs::path& folder) {
    std::string name = (folder / ".shlmbench-XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) return false;
    close(file);
    unlink(name.c_str());
    return true;
}

fs::path temporary_beside(const fs::path& file) {
    return file.parent_path() /
           fmt::format(".{}.{}{}", file.stem().string(), getpid(), file.extension().string());
}

void check_output_file(const std::string& option, const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;  // a path that cannot be examined counts as no folder
    if (!fs::is_directory(folder, ignored))
        throw InputError(
            fmt::format("{}: {}: there is no folder {}", option, file.string(), folder.string()));
    if (const int trouble = trouble_with_making(temporary_beside(file)); trouble == ENAMETOOLONG)
        throw InputError(fmt::format("{}: the name of {} is too long", option, file.string()));
    else if (trouble != 0)
        throw InputError(fmt::format("{}: {} cannot be written to", option, folder.string()));
    if (fs::is_directory(file, ignored))
        throw InputError(fmt::format("{}: {} is a folder", option, file.string()));
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
        throw InputError(fmt::format("{}: {} is no regular file", option, file.string()));
}

void refuse_input_as_output(const std::string& option, const fs::path& output,
                            std::span<const fs::path> inputs) {
    for (const fs::path& input : inputs) {
        std::error_code one_is_missing;
        if (fs::equivalent(output, input, one_is_missing) && !one_is_missing)
            throw InputError(fmt::format("{}: {} would take the place of {}, which is read", option,
                                         output.string(), input.string()));
    }
}

void write_whole_file(const fs::path& file, std::span<const std::byte> bytes) {
    const fs::path temporary = temporary_beside(file);
    const auto fail = [&](int error) {
        unlink(temporary.c_str());
        throw InputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(error)));
    };
    const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(errno);
    int error = write_all(descriptor, bytes);
    // A full disk may report its error only here.
    if (error == 0 && fsync(descriptor) != 0 && errno != EINVAL && errno != ENOSYS) error = errno;
    if (close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
    if (error != 0) fail(error);
}

}  // namespace common
