#include "common/image/image.h"

#include <Imath/half.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/core/input_error.h"
#include "common/core/output_file.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// Writes with OpenImageIO under a name beside `file`, then renames.
void write_safely(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                  const void* values) {
    const fs::path temporary = temporary_beside(file);
    const auto fail = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw InputError(fmt::format("{}: cannot be written: {}", file.string(), why));
    };
    const auto out = OIIO::ImageOutput::create(temporary.string());
    if (!out) fail("no writer for this kind of file");
    if (!out->open(temporary.string(), spec)) fail(out->geterror());
    if (!out->write_image(type, values)) fail(out->geterror());
    if (!out->close()) fail(out->geterror());
    std::error_code error;
    fs::rename(temporary, file, error);
    if (error) fail(error.message());
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& file) {
    auto in = OIIO::ImageInput::open(file.string());
    if (!in) throw InputError(fmt::format("{}: cannot be read: {}", file.string(), OIIO::geterror()));
    return in;
}

OIIO::ImageSpec png_spec(int width, int height, const char* shows) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute(shown_note, shows);
    return spec;
}

/// sRGB transfer function (IEC 61966-2-1).
float srgb_encoded(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

/// Leaves dark values alone and takes 4 times white to white (Reinhard et al. 2002, eq. 4).
float rolled_off(float value) {
    constexpr float white = 4;
    value = std::max(value, 0.0f);
    return std::min(1.0f, value * (1 + value / (white * white)) / (1 + value));
}

}  // namespace

std::optional<std::size_t> Image::find_channel(std::string_view name) const {
    const auto found = std::find(channels.begin(), channels.end(), name);
    if (found == channels.end()) return std::nullopt;
    return found - channels.begin();
}

bool fits_in_halves(const Image& image) {
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        double sum = 0;
        for (std::size_t p = 0; p < image.pixel_count(); ++p) sum += std::abs(double{image.at(p, c)});
        const double mean = sum / static_cast<double>(image.pixel_count());
        for (std::size_t p = 0; p < image.pixel_count(); ++p) {
            const double value = image.at(p, c), kept = float{Imath::half(image.at(p, c))};
            // So put, what is not finite does not fit either.
            if (!(std::abs(kept - value) <= largest_half_loss * std::hypot(value, 0.1 * mean))) return false;
        }
    }
    return true;
}

void write_exr(const fs::path& file, const Image& image, const ImageNotes& notes, Precision precision) {
    const bool half = precision == Precision::half && fits_in_halves(image);
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         half ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.channelnames = image.channels;
    spec.attribute("compression", "zip");
    for (const auto& [name, text] : notes) spec.attribute(name, text);
    write_safely(file, spec, OIIO::TypeFloat, image.values.data());
}

void write_png(const fs::path& file, const Image& image, float exposure) {
    std::vector<float> encoded;
    encoded.reserve(image.pixel_count() * 3);
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            encoded.push_back(srgb_encoded(rolled_off(image.at(p, c) * exposure)));
    write_safely(file, png_spec(image.width, image.height, picture_of_light), OIIO::TypeFloat,
                 encoded.data());
}

void write_png(const fs::path& file, int width, int height, std::span<const DisplayColor> colors) {
    write_safely(file, png_spec(width, height, picture_of_errors), OIIO::TypeUInt8, colors.data());
}

bool holds_linear_values(const fs::path& file) {
    return open_image(file)->spec().format.is_floating_point();
}

PictureWindow read_window(const fs::path& file) {
    const auto in = open_image(file);
    const OIIO::ImageSpec& spec = in->spec();
    return {spec.x - spec.full_x, spec.y - spec.full_y, spec.width,
            spec.height,          spec.full_width,      spec.full_height};
}

Image read_image(const fs::path& file) {
    const auto in = open_image(file);
    const OIIO::ImageSpec& spec = in->spec();
    Image image{spec.width, spec.height, spec.channelnames, {}};
    image.values.resize(image.pixel_count() * image.channels.size());
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.values.data()))
        throw InputError(fmt::format("{}: cannot be read: {}", file.string(), in->geterror()));
    return image;
}

ImageNotes read_notes(const fs::path& file) {
    const auto in = open_image(file);
    ImageNotes notes;
    for (const OIIO::ParamValue& attribute : in->spec().extra_attribs)
        if (attribute.type() == OIIO::TypeString) notes[attribute.name().string()] = attribute.get_string();
    return notes;
}

float middle_grey_exposure(const Image& image) {
    constexpr double middle_grey = 0.18;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        const double brightness = (image.at(p, 0) + image.at(p, 1) + image.at(p, 2)) / 3.0;
        if (!(brightness > 0)) continue;
        sum += std::log(brightness);
        ++count;
    }
    return count == 0 ? 1.0f : static_cast<float>(middle_grey / std::exp(sum / static_cast<double>(count)));
}

}  // namespace common
