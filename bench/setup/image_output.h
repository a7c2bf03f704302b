// Checks the file of an image before the work starts.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Returns the name of the PNG beside an image.
[[nodiscard]] std::filesystem::path picture_of(const std::filesystem::path& image);

/// Throws InputError in these cases: `out` is no .exr file in a writable folder; the size is no valid image
/// size; the PNG beside it exists and is not from an earlier run; or one of both is, by any path or link, one
/// of the inputs. `inputs` is called only if one of the files exists.
void check_image_output(const std::string& out, int width, int height,
                        const std::function<std::vector<std::filesystem::path>()>& inputs);

/// Throws InputError where `out` exists and is not an image that render made.
void check_replaces_a_rendered_image(const std::string& out);

/// Throws InputError, naming `option`, where `file` cannot be written, or exists and was not written by this
/// program to show the same (common/image/image.h).
void check_png_output(const std::string& option, const std::filesystem::path& file, const std::string& shows);

}  // namespace bench
