#include "bench/app/image_output.h"

#include <fmt/format.h>

#include <filesystem>

#include "common/core/input_error.h"
#include "common/core/writable_folder.h"

namespace bench {

void check_image_output(const std::string& file, int width, int height) {
    const std::filesystem::path out(file);
    if (out.extension() != ".exr") throw common::InputError("--out: the image is an .exr file");
    const auto folder = out.has_parent_path() ? out.parent_path() : std::filesystem::path(".");
    std::error_code ignored;  // a path that cannot be looked at is no folder either
    if (!std::filesystem::is_directory(folder, ignored))
        throw common::InputError(fmt::format("--out: there is no folder {}", folder.string()));
    if (!common::is_writable_folder(folder))
        throw common::InputError(fmt::format("--out: {} cannot be written to", folder.string()));
    if (std::filesystem::is_directory(out, ignored))
        throw common::InputError(fmt::format("--out: {} is a folder", out.string()));
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        throw common::InputError("--width and --height: from 1 to 16384");
}

}  // namespace bench
