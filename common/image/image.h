// Images with named channels, and image files.
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

/// Pixels row by row from the top left one, the channels of a pixel side by side.
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

    /// Returns the index of the channel with this name, if there is one.
    [[nodiscard]] std::optional<std::size_t> find_channel(std::string_view name) const;
};

/// Text attributes of an image file: how the image was made.
using ImageNotes = std::map<std::string, std::string>;

/// The precision of the values in an image file.
enum class Precision {
    half,   ///< 11 significant bits, for pictures; single where half would lose more than largest_half_loss
            ///< of a value
    single  ///< 24 significant bits, for images from which other numbers are computed
};

/// The largest loss of a value v as half, relative to sqrt(v^2 + 0.01 m^2), where m is the mean magnitude of
/// its channel: the relative error of common/difference. Values within the range of half floats lose less.
inline constexpr double largest_half_loss = 0x1p-11;

/// Returns whether no value of the image, too small or too large, loses more than that as a half float.
[[nodiscard]] bool fits_in_halves(const Image& image);

/// Writes a ZIP-compressed OpenEXR file under a temporary name and renames it to `file`, which is thus never
/// incomplete. Channels named in `always_single` are never halves. Throws InputError if it cannot be written.
void write_exr(const std::filesystem::path& file, const Image& image, const ImageNotes& notes,
               Precision precision = Precision::half, std::span<const std::string> always_single = {});

/// The note in a PNG written by this program that says what it shows. Files without it come from elsewhere.
inline constexpr const char* shown_note = "shlmbench:shows";
inline constexpr const char* picture_of_light = "light";    ///< scaled, and rolled off towards white
inline constexpr const char* picture_of_errors = "errors";  ///< or other values, in colours of their own

/// Writes the first three channels, linear, as an sRGB PNG; values are scaled by `exposure` and rolled off
/// towards white. Replaces `file` and throws as write_exr() does.
void write_png(const std::filesystem::path& file, const Image& image, float exposure);

/// An sRGB pixel of 8 bits per channel.
using DisplayColor = std::array<std::uint8_t, 3>;

/// Writes the colours unchanged, row by row from the top left pixel. Replaces `file` and throws as
/// write_exr() does.
void write_png(const std::filesystem::path& file, int width, int height,
               std::span<const DisplayColor> colors);

/// Returns a PNG of 8 bits per channel, with 3 or 4 channels, and says nothing of the colour space: for
/// textures in other files. `values` are row by row from the top left pixel.
[[nodiscard]] std::vector<std::byte> encode_png(int width, int height, int channels,
                                                std::span<const std::uint8_t> values);

/// Returns whether a file's values are floating-point numbers, linear in light, and not display colours.
/// Throws InputError if it cannot be read.
[[nodiscard]] bool holds_linear_values(const std::filesystem::path& file);

/// The position of a file's pixels within its picture: OpenEXR's data window, relative to the upper left
/// corner of its display window. In all other formats the pixels fill the picture.
struct PictureWindow {
    int x = 0, y = 0;           ///< of the first pixel
    int width = 0, height = 0;  ///< of the pixels
    int picture_width = 0, picture_height = 0;

    [[nodiscard]] bool operator==(const PictureWindow&) const = default;
};

/// Returns the window of a file. Throws InputError if it cannot be read.
[[nodiscard]] PictureWindow read_window(const std::filesystem::path& file);

/// Reads any image file as float. Throws InputError if it cannot be read.
[[nodiscard]] Image read_image(const std::filesystem::path& file);

/// Returns the text attributes of an image file. Throws InputError if it cannot be read.
[[nodiscard]] ImageNotes read_notes(const std::filesystem::path& file);

/// Returns the scale that maps the mean logarithm of brightness, over pixels that are not black, to a middle
/// grey.
[[nodiscard]] float middle_grey_exposure(const Image& image);

}  // namespace common
