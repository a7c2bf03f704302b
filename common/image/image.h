// Images with named channels, and the files they live in.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

    /// Where a channel of this name is, if there is one.
    [[nodiscard]] std::optional<std::size_t> find_channel(std::string_view name) const;
};

/// Text attributes of an image file: how the image was made.
using ImageNotes = std::map<std::string, std::string>;

/// How exactly an image file keeps its values.
enum class Precision {
    half,   ///< 11 significant bits: pictures; single where that takes more of a value than largest_half_loss
    single  ///< 24: what other numbers are computed from
};

/// Of a value v, as a part of sqrt(v^2 + 0.01 m^2), m being the mean of its channel's magnitudes: the
/// relative error as common/difference has it. What is not out of the half floats' range loses less.
inline constexpr double largest_half_loss = 0x1p-11;

/// Whether no value of the image loses more than that as a half float, be it too small or too large.
[[nodiscard]] bool fits_in_halves(const Image& image);

/// Writes OpenEXR, ZIP compressed, under a temporary name that is then moved to `file`: there is never half a
/// file. Throws InputError where it cannot be written.
void write_exr(const std::filesystem::path& file, const Image& image, const ImageNotes& notes,
               Precision precision = Precision::half);

/// The note of a PNG that was written here: what it shows. Files without it are somebody else's.
inline constexpr const char* shown_note = "shlmbench:shows";
inline constexpr const char* picture_of_light = "light";    ///< scaled and rolled off
inline constexpr const char* picture_of_errors = "errors";  ///< or whatever else, by colours of its own

/// Writes the first three channels, linear, as an sRGB PNG; values are scaled by `exposure` and rolled off
/// towards white. Same safety and error as write_exr.
void write_png(const std::filesystem::path& file, const Image& image, float exposure);

/// An sRGB pixel as it is shown.
using DisplayColor = std::array<std::uint8_t, 3>;

/// Writes the colours as they are, row by row from the top left pixel. Same safety and error as write_exr.
void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const DisplayColor> colors);

/// Whether a file's values are floating-point numbers, linear in light, and no display colours. Throws
/// InputError where it cannot be read.
[[nodiscard]] bool holds_linear_values(const std::filesystem::path& file);

/// Where the pixels of a file lie in the picture that it is of: OpenEXR's data window, from the upper left
/// corner of its display window. All other kinds of file fill it.
struct PictureWindow {
    int x = 0, y = 0;           ///< of the first pixel
    int width = 0, height = 0;  ///< of the pixels
    int picture_width = 0, picture_height = 0;

    [[nodiscard]] bool operator==(const PictureWindow&) const = default;
};

/// Throws InputError where the file cannot be read.
[[nodiscard]] PictureWindow read_window(const std::filesystem::path& file);

/// Reads any image file as float. Throws InputError where it cannot be read.
[[nodiscard]] Image read_image(const std::filesystem::path& file);

/// The text attributes of an image file. Throws InputError where it cannot be read.
[[nodiscard]] ImageNotes read_notes(const std::filesystem::path& file);

/// Scale that brings the mean of the logarithm of brightness, over pixels that are not black, to a middle
/// grey.
[[nodiscard]] float middle_grey_exposure(const Image& image);

}  // namespace common
