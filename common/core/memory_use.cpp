#include "common/core/memory_use.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace common {
namespace {

/// Value of the line "NAME:   VALUE kB" in a file under /proc, in bytes.
std::size_t proc_bytes(const char* file, const std::string& name) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(name + ":")) return std::stoull(line.substr(name.size() + 1)) * 1024;
    return 0;
}

/// Returns the bytes left under the limit of this process's cgroup (version 2). Droppable page cache does not
/// count as used.
std::size_t left_in_control_group() {
    constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
    std::string group;
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::")) group = line.substr(3);
    const std::string folder = "/sys/fs/cgroup" + group;
    std::size_t limit = 0, used = 0, droppable = 0;
    if (!(std::ifstream(folder + "/memory.max") >> limit)) return no_limit;  // none, or "max"
    std::ifstream(folder + "/memory.current") >> used;
    std::ifstream statistics(folder + "/memory.stat");
    for (std::string key; statistics >> key && key != "inactive_file";) statistics.ignore(64, '\n');
    statistics >> droppable;
    used -= std::min(used, droppable);
    return limit - std::min(limit, used);
}

}  // namespace

std::size_t heap_bytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return __sanitizer_get_current_allocated_bytes();  // the sanitizers replace malloc, and with it mallinfo2
#else
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

std::size_t peak_resident_bytes() {
    return proc_bytes("/proc/self/status", "VmHWM");
}

std::size_t resident_bytes() {
    std::size_t whole = 0, resident = 0;  // pages
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

bool reset_peak_resident_bytes() {
    malloc_trim(0);
    std::ofstream out("/proc/self/clear_refs");
    out << 5 << std::flush;  // proc(5): resets the peak resident size
    return out.good();
}

std::size_t available_bytes() {
    return std::min(proc_bytes("/proc/meminfo", "MemAvailable"), left_in_control_group());
}

}  // namespace common
