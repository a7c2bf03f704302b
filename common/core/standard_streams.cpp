#include "common/core/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace common {

void secure_standard_streams() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // In ascending order, as open() returns the lowest free number. Read-only, so that writes still fail.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) (void)open("/dev/null", O_RDONLY);
}

std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
    return line;
}

void say(std::string_view line) {
    const std::string text = one_line(line) + '\n';
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_result(std::string_view text) {
    (void)std::fwrite(text.data(), 1, text.size(), stdout);
}

bool results_are_written() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace common
