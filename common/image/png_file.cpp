// Writes and reads PNG files.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <stdexcept>

#include "common/core/input_error.h"
#include "common/core/output_file.h"
#include "common/image/image_reader.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// sRGB transfer function (IEC 61966-2-1).
float srgb_encoded(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

/// Compresses bright values: keeps dark ones and maps 4 times white to white (Reinhard et al. 2002, eq. 4).
float rolled_off(float value) {
    constexpr float white = 4;
    value = std::max(value, 0.0f);
    return std::min(1.0f, value * (1 + value / (white * white)) / (1 + value));
}

using Bytes = std::vector<std::byte>;

// libpng reports an error by longjmp to the last setjmp, which skips all destructors between. So the caller
// creates the objects that are used between the two calls.

void keep_message(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    auto& file = *static_cast<Bytes*>(png_get_io_ptr(png));
    const auto* const first = reinterpret_cast<const std::byte*>(bytes);
    file.insert(file.end(), first, first + count);
}

/// Returns false if it failed; `rows` has one pointer per row. With a note the values are sRGB, without one
/// they are whatever the reader takes them for.
bool encode(png_structp png, png_infop info, int width, int height, int channels, png_textp note,
            png_bytepp rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (note) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_set_text(png, info, note, 1);
    }
    png_set_rows(png, info, rows);
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    return true;
}

/// Throws InputError, naming `file`.
Bytes encoded(const std::string& file, int width, int height, int channels,
              std::span<const std::uint8_t> values, png_textp note) {
    std::vector<png_bytep> rows;
    const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)  // libpng takes no const pointers
        rows.push_back(const_cast<png_bytep>(values.data() + y * row));
    Bytes bytes;
    std::string message;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    const bool done = encode(png, info, width, height, channels, note, rows.data());
    png_destroy_write_struct(&png, &info);
    if (!done) throw InputError(fmt::format("{}: cannot be written: {}", file, message));
    return bytes;
}

void write_colors(const fs::path& file, int width, int height, std::span<const DisplayColor> colors,
                  std::string shows) {
    std::string key = shown_note;
    png_text note{};
    note.compression = PNG_TEXT_COMPRESSION_NONE;
    note.key = key.data();
    note.text = shows.data();
    note.text_length = shows.size();
    static_assert(sizeof(DisplayColor) == 3);
    write_whole_file(file,
                     encoded(file.string(), width, height, 3,
                             {colors.empty() ? nullptr : colors.front().data(), 3 * colors.size()}, &note));
}

/// An open file and libpng's state for it.
struct PngFile {
    explicit PngFile(const fs::path& file) : stream(std::fopen(file.c_str(), "rb")) {}
    ~PngFile() {
        png_destroy_read_struct(&png, &info, nullptr);
        if (stream) std::fclose(stream);
    }
    PngFile(const PngFile&) = delete;
    PngFile& operator=(const PngFile&) = delete;

    [[nodiscard]] bool read_header() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_init_io(png, stream);
        png_set_sig_bytes(png, signature_bytes);
        png_read_info(png, info);
        return true;
    }

    [[nodiscard]] bool read_rows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        png_read_image(png, rows);
        return true;
    }

    static constexpr int signature_bytes = 8;
    std::FILE* stream;
    std::string message;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
    png_infop info = png_create_info_struct(png);
};

ImageHeader header_of(const PngFile& file) {
    const int width = static_cast<int>(png_get_image_width(file.png, file.info)),
              height = static_cast<int>(png_get_image_height(file.png, file.info));
    ImageHeader header{{0, 0, width, height, width, height}, {"R", "G", "B"}, false, {}};
    if (png_get_channels(file.png, file.info) == 1) header.channels = {"Y"};
    png_textp text = nullptr;
    int texts = 0;
    png_get_text(file.png, file.info, &text, &texts);
    for (int i = 0; i < texts; ++i) header.notes[text[i].key] = text[i].text;
    return header;
}

class PngReader : public ImageReader {
  public:
    PngReader(std::unique_ptr<PngFile> file, std::uintmax_t file_bytes)
        : ImageReader(header_of(*file)), file_(std::move(file)), file_bytes_(file_bytes) {}

    std::vector<float> read_values() override {
        const std::size_t row = header().channels.size() * static_cast<std::size_t>(header().window.width);
        constexpr double most_packed = 2e3;  // deflate compresses to a thousandth at most
        check_can_hold(file_bytes_, static_cast<double>(row) * header().window.height, most_packed);
        std::vector<png_byte> bytes(row * static_cast<std::size_t>(header().window.height));
        std::vector<png_bytep> rows;
        for (std::size_t begin = 0; begin < bytes.size(); begin += row) rows.push_back(bytes.data() + begin);
        if (!file_->read_rows(rows.data())) throw std::runtime_error(file_->message);
        std::vector<float> values(bytes.begin(), bytes.end());
        for (float& value : values) value /= 255;
        return values;
    }

  private:
    std::unique_ptr<PngFile> file_;
    std::uintmax_t file_bytes_;
};

}  // namespace

void write_png(const fs::path& file, const Image& image, float exposure) {
    std::vector<DisplayColor> colors(image.pixel_count());
    for (std::size_t p = 0; p < colors.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            colors[p][c] = static_cast<std::uint8_t>(
                std::lround(255 * srgb_encoded(rolled_off(image.at(p, c) * exposure))));
    write_colors(file, image.width, image.height, colors, picture_of_light);
}

std::vector<std::byte> encode_png(int width, int height, int channels, std::span<const std::uint8_t> values) {
    return encoded("PNG", width, height, channels, values, nullptr);
}

void write_png(const fs::path& file, int width, int height, std::span<const DisplayColor> colors) {
    write_colors(file, width, height, colors, picture_of_errors);
}

std::unique_ptr<ImageReader> open_png(const fs::path& path) {
    auto file = std::make_unique<PngFile>(path);
    png_byte signature[PngFile::signature_bytes];
    if (!file->stream || std::fread(signature, 1, sizeof signature, file->stream) != sizeof signature ||
        png_sig_cmp(signature, 0, sizeof signature) != 0)
        return nullptr;
    if (!file->read_header()) throw std::runtime_error(file->message);
    const int type = png_get_color_type(file->png, file->info);
    if (png_get_bit_depth(file->png, file->info) != 8 ||
        (type != PNG_COLOR_TYPE_RGB && type != PNG_COLOR_TYPE_GRAY) ||
        png_get_valid(file->png, file->info, PNG_INFO_tRNS) != 0)
        return nullptr;
    return std::make_unique<PngReader>(std::move(file), fs::file_size(path));
}

}  // namespace common
