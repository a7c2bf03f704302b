// Where an image goes, looked at before the work starts.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// The PNG beside an image.
[[nodiscard]] std::filesystem::path picture_of(const std::filesystem::path& image);

/// Throws InputError where `out` is no .exr file in a folder that can be written to, the size is not one of
/// an image, the PNG beside it is none that an earlier run made, or one of the two is, by whatever path or
/// link, one of the inputs. Those are asked for only where something is there already.
void check_image_output(const std::string& out, int width, int height,
                        const std::function<std::vector<std::filesystem::path>()>& inputs);

/// Throws InputError where `out` is there and no image that render made.
void check_replaces_a_rendered_image(const std::string& out);

/// Throws InputError, naming `option`, where `file` cannot be written or is there and none that this program
/// wrote to show that (common/image/image.h).
void check_png_output(const std::string& option, const std::filesystem::path& file, const std::string& shows);

}  // namespace bench
