#include "common/image/other_formats.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace common {
namespace {

namespace fs = std::filesystem;

/// Loads the module from beside the program, where it was built, or where it was installed.
void* load_module() {
    std::error_code unknown;
    const fs::path beside = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    std::string trouble;
    for (const fs::path& folder : {beside, fs::path(SHLMBENCH_BUILT_IN), fs::path(SHLMBENCH_INSTALLED_IN)}) {
        const fs::path file = folder / SHLMBENCH_IMAGE_MODULE;
        if (!fs::exists(file, unknown)) continue;
        if (void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
        trouble = dlerror();
    }
    // Searches where the program's own libraries are found.
    if (void* const module = dlopen(SHLMBENCH_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL)) return module;
    throw std::runtime_error(
        fmt::format("it is neither OpenEXR nor PNG of 8 bits, and OpenImageIO is not there for it{}{}",
                    trouble.empty() ? "" : ": ", trouble));
}

}  // namespace

std::unique_ptr<ImageReader> open_other_format(const fs::path& file) {
    // Never unloaded, as readers run its code.
    static void* const module = load_module();
    const auto open = reinterpret_cast<OpenOtherFormat*>(dlsym(module, open_other_format_symbol));
    if (!open) throw std::runtime_error(dlerror());
    std::string error;
    std::unique_ptr<ImageReader> reader(open(file.c_str(), error));
    if (!reader) throw std::runtime_error(error);
    return reader;
}

}  // namespace common
