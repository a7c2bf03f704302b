#include "common/image/image.h"

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "common/core/input_error.h"
#include "common/image/image_reader.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// Returns what `work` returns. Turns its exceptions, except a lack of memory, into one line about the file.
template <class Work>
auto while_reading(const fs::path& file, const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        throw InputError(fmt::format("{}: cannot be read: {}", file.string(), e.what()));
    }
}

std::unique_ptr<ImageReader> open_image(const fs::path& file) {
    return while_reading(file, [&] {
        if (std::error_code unknown; !fs::exists(file, unknown)) throw InputError("there is no such file");
        if (auto exr = open_exr(file)) return exr;
        if (auto png = open_png(file)) return png;
        return open_other_format(file);
    });
}

}  // namespace

void check_can_hold(std::uintmax_t file_bytes, double pixel_bytes, double most_packed) {
    constexpr double always_fine = 0x1p28;
    if (pixel_bytes > always_fine && pixel_bytes > most_packed * static_cast<double>(file_bytes))
        throw std::runtime_error("it is much too short for its pixels");
}

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
            // The negated comparison also rejects values that are not finite.
            if (!(std::abs(kept - value) <= largest_half_loss * std::hypot(value, 0.1 * mean))) return false;
        }
    }
    return true;
}

bool holds_linear_values(const fs::path& file) {
    return open_image(file)->header().has_linear_values;
}

PictureWindow read_window(const fs::path& file) {
    return open_image(file)->header().window;
}

Image read_image(const fs::path& file) {
    const auto reader = open_image(file);
    const ImageHeader& header = reader->header();
    return while_reading(file, [&] {
        return Image{header.window.width, header.window.height, header.channels, reader->read_values()};
    });
}

ImageNotes read_notes(const fs::path& file) {
    return open_image(file)->header().notes;
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
