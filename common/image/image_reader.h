// One opened image file, whatever its kind.
#pragma once

#include <cstdint>
#include <memory>

#include "common/image/image.h"

namespace common {

/// What a file says before its pixels.
struct ImageHeader {
    PictureWindow window;
    std::vector<std::string> channels;
    bool has_linear_values = false;  ///< floating-point numbers, and no display colours
    ImageNotes notes;
};

class ImageReader {
  public:
    explicit ImageReader(ImageHeader header) : header_(std::move(header)) {}
    virtual ~ImageReader() = default;
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    [[nodiscard]] const ImageHeader& header() const { return header_; }

    /// As Image::values. Throws std::exception where the file breaks off.
    [[nodiscard]] virtual std::vector<float> read_values() = 0;

  private:
    ImageHeader header_;
};

/// Throws std::exception where pixels of so many bytes cannot be in a file of `file_bytes`, whose compression
/// makes `most_packed` of one at most: such a header is broken, and no room is made for what it says.
void check_can_hold(std::uintmax_t file_bytes, double pixel_bytes, double most_packed);

// Each opens a file of its kind: null where the file is of another, std::exception where it is broken.

/// Flat OpenEXR files, scan lines or tiles, without subsampled channels; of several parts the first.
[[nodiscard]] std::unique_ptr<ImageReader> open_exr(const std::filesystem::path& file);

/// PNG of 8 bits, grey or RGB, without transparency.
[[nodiscard]] std::unique_ptr<ImageReader> open_png(const std::filesystem::path& file);

/// All that OpenImageIO reads. Never null. It brings some 250 shared libraries, a third of a second: they are
/// loaded with the first file that comes here.
[[nodiscard]] std::unique_ptr<ImageReader> open_other_format(const std::filesystem::path& file);

}  // namespace common
