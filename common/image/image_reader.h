// An open image file of any format.
#pragma once

#include <cstdint>
#include <memory>

#include "common/image/image.h"

namespace common {

/// The contents of a file that precede its pixels.
struct ImageHeader {
    PictureWindow window;
    std::vector<std::string> channels;
    bool has_linear_values = false;  ///< floating-point numbers, not display colours
    ImageNotes notes;
};

class ImageReader {
  public:
    explicit ImageReader(ImageHeader header) : header_(std::move(header)) {}
    virtual ~ImageReader() = default;
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    [[nodiscard]] const ImageHeader& header() const { return header_; }

    /// Returns the values in the layout of Image::values. Throws std::exception if the file is truncated.
    [[nodiscard]] virtual std::vector<float> read_values() = 0;

  private:
    ImageHeader header_;
};

/// Throws std::exception if pixels of `pixel_bytes` cannot be in a file of `file_bytes`, of which each byte
/// holds at most `most_packed` bytes of pixels. The header is then broken, and no memory is allocated for it.
void check_can_hold(std::uintmax_t file_bytes, double pixel_bytes, double most_packed);

// Each of these opens a file of its format: null for a file of another, std::exception for a broken one.

/// Opens flat OpenEXR files, scan lines or tiles, without subsampled channels; of several parts the first.
[[nodiscard]] std::unique_ptr<ImageReader> open_exr(const std::filesystem::path& file);

/// Opens PNG of 8 bits, grey or RGB, without transparency.
[[nodiscard]] std::unique_ptr<ImageReader> open_png(const std::filesystem::path& file);

/// Opens all formats that OpenImageIO reads. Never returns null. OpenImageIO brings some 250 shared
/// libraries, which take a third of a second to load. So it is loaded with the first file that needs it.
[[nodiscard]] std::unique_ptr<ImageReader> open_other_format(const std::filesystem::path& file);

}  // namespace common
