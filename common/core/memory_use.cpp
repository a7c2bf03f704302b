#include "common/core/memory_use.h"

#include <malloc.h>

#include <fstream>
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

}  // namespace

std::size_t heap_bytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return __sanitizer_get_current_allocated_bytes();  // they replace malloc, and with it mallinfo2
#else
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

std::size_t peak_resident_bytes() {
    return proc_bytes("/proc/self/status", "VmHWM");
}

void reset_peak_resident_bytes() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // proc(5): resets the peak resident size
}

std::size_t available_bytes() {
    return proc_bytes("/proc/meminfo", "MemAvailable");
}

}  // namespace common
