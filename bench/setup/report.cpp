#include "bench/setup/report.h"

#include <fmt/format.h>

#include <cstdlib>

#include "bench/setup/build_info.h"

namespace bench {
namespace {

std::string shell_quoted(const std::string& text) {
    std::string quoted = "'";
    for (char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace

bool write_report(const std::string& name, const std::filesystem::path& folder) {
    const std::string command =
        fmt::format("/usr/bin/python3 {} {} {}", shell_quoted(fmt::format("{}/bench/report", source_folder)),
                    name, shell_quoted(folder.string()));
    return std::system(command.c_str()) == 0;
}

}  // namespace bench
