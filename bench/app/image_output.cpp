#include "bench/app/image_output.h"

#include <fmt/format.h>

#include <filesystem>

#include "common/core/input_error.h"
#include "common/core/output_file.h"

namespace bench {

void check_image_output(const std::string& file, int width, int height) {
    const std::filesystem::path out(file);
    if (out.extension() != ".exr") throw common::InputError("--out: the image is an .exr file");
    common::check_output_file("--out", out);
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        throw common::InputError("--width and --height: from 1 to 16384");
}

}  // namespace bench
