// Images with named channels, and the files they live in.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace common {

/// Row by row from the top left pixel, the channels of a pixel side by side.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> values;  ///< width * height * channels.size()

    [[nodiscard]] std::size_t pixel_count() const { return static_cast<std::size_t>(width) * height; }
    [[nodiscard]] float& at(std::size_t pixel, std::size_t channel) {
        return values[pixel * channels.size() + channel];
    }
    [[nodiscard]] float at(std::size_t pixel, std::size_t channel) const {
        return values[pixel * channels.size() + channel];
    }
};

/// Text attributes of an image file: how the image was made.
using ImageNotes = std::map<std::string, std::string>;

/// Writes half-float OpenEXR, ZIP compressed, under a temporary name that is then moved to `file`: there is
/// never half a file. Throws InputError where it cannot be written.
void write_exr(const std::filesystem::path& file, const Image& image, const ImageNotes& notes);

/// Writes the first three channels, linear, as an sRGB PNG; values are scaled by `exposure` and rolled off
/// towards white. Same safety and error as write_exr.
void write_png(const std::filesystem::path& file, const Image& image, float exposure);

/// Reads any image file as float. Throws InputError where it cannot be read.
[[nodiscard]] Image read_image(const std::filesystem::path& file);

/// Scale that brings the mean of the logarithm of brightness, over pixels that are not black, to a middle
/// grey.
[[nodiscard]] float middle_grey_exposure(const Image& image);

}  // namespace common
