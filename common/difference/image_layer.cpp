#include "common/difference/image_layer.h"

#include <fmt/ranges.h>

#include "common/core/input_error.h"
#include "common/image/image.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// An image file's pixels within its picture, and its name for messages.
struct NamedImage {
    std::string name;
    Image image;
    PictureWindow window;  ///< of these pixels
};

using Channels = std::array<std::string, 3>;

struct Layer {
    std::string name;
    Channels channels;
};

/// Returns the part of the window inside the picture; its width or height is not positive if there is none.
PictureWindow within_picture(const PictureWindow& window) {
    PictureWindow part = window;
    part.x = std::max(window.x, 0);
    part.y = std::max(window.y, 0);
    part.width = std::min(window.x + window.width, window.picture_width) - part.x;
    part.height = std::min(window.y + window.height, window.picture_height) - part.y;
    return part;
}

/// Returns the pixels of `part`, which lies inside `whole`, the window of `image`.
Image cropped(Image image, const PictureWindow& whole, const PictureWindow& part) {
    if (part == whole) return image;
    Image kept{part.width, part.height, image.channels, {}};
    const std::size_t channels = image.channels.size();
    for (int y = 0; y < part.height; ++y) {
        const auto first = static_cast<std::size_t>(y + part.y - whole.y) * image.width + (part.x - whole.x);
        const auto row = image.values.begin() + static_cast<std::ptrdiff_t>(first * channels);
        kept.values.insert(kept.values.end(), row, row + static_cast<std::ptrdiff_t>(part.width * channels));
    }
    return kept;
}

NamedImage read(const fs::path& file) {
    if (!holds_linear_values(file))
        throw InputError(
            fmt::format("{}: holds display colours; linear values are compared, as in .exr", file.string()));
    const PictureWindow window = read_window(file), seen = within_picture(window);
    if (seen.width <= 0 || seen.height <= 0)
        throw InputError(fmt::format(
            "{}: no pixel lies in the picture: its data window is beside its display window", file.string()));
    return {file.string(), cropped(read_image(file), window, seen), seen};
}

bool has(const Image& image, const Layer& layer) {
    return std::all_of(layer.channels.begin(), layer.channels.end(),
                       [&](const std::string& channel) { return image.find_channel(channel).has_value(); });
}

/// Returns "8 x 6", or "8 x 6 at (2, 0) of 16 x 6" for a window that is not the whole picture.
std::string describe(const PictureWindow& window) {
    const std::string size = fmt::format("{} x {}", window.width, window.height);
    if (window.width == window.picture_width && window.height == window.picture_height) return size;
    return fmt::format("{} at ({}, {}) of {} x {}", size, window.x, window.y, window.picture_width,
                       window.picture_height);
}

void check_windows(const NamedImage& a, const NamedImage& b) {
    if (!(a.window == b.window))
        throw InputError(fmt::format("{} has {} pixels, {} has {}", a.name, describe(a.window), b.name,
                                     describe(b.window)));
}

Layer common_layer(const NamedImage& a, const NamedImage& b) {
    const std::array<Layer, 2> layers = {
        {{"irradiance", {"irradiance.R", "irradiance.G", "irradiance.B"}}, {"radiance", {"R", "G", "B"}}}};
    for (const Layer& layer : layers)
        if (has(a.image, layer) && has(b.image, layer)) return layer;
    throw InputError(
        fmt::format("neither irradiance.R, .G, .B nor R, G, B is in both images: {} has {}; {} has {}",
                    a.name, fmt::join(a.image.channels, ","), b.name, fmt::join(b.image.channels, ",")));
}

std::vector<Rgb> pixels_of(const Image& image, const Layer& layer) {
    std::array<std::size_t, 3> place{};
    for (std::size_t c = 0; c < 3; ++c) place[c] = *image.find_channel(layer.channels[c]);
    std::vector<Rgb> pixels;
    pixels.reserve(image.pixel_count());
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        pixels.emplace_back(image.at(p, place[0]), image.at(p, place[1]), image.at(p, place[2]));
    return pixels;
}

/// Returns channel A; empty if there is none.
std::vector<float> coverage_of(const Image& image) {
    const auto place = image.find_channel("A");
    std::vector<float> coverage;
    for (std::size_t p = 0; place && p < image.pixel_count(); ++p) coverage.push_back(image.at(p, *place));
    return coverage;
}

/// Reports how many pixels are not finite and where the first is; empty if all are finite.
std::string not_finite(const NamedImage& named, const std::vector<Rgb>& pixels,
                       const std::vector<float>& coverage) {
    std::size_t count = 0, first = 0;
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        if (is_finite(pixels[p]) && (coverage.empty() || std::isfinite(coverage[p]))) continue;
        if (count++ == 0) first = p;
    }
    if (count == 0) return "";
    const auto width = static_cast<std::size_t>(named.image.width);
    return fmt::format("{}: {} of {} pixels are not finite, the first of them ({}, {})", named.name, count,
                       pixels.size(), named.window.x + first % width, named.window.y + first / width);
}

void check_finite(const std::string& image_trouble, const std::string& reference_trouble) {
    if (image_trouble.empty() && reference_trouble.empty()) return;
    const bool both = !image_trouble.empty() && !reference_trouble.empty();
    throw InputError(image_trouble + (both ? "; " : "") + reference_trouble);
}

std::vector<std::size_t> pixels_with_surface(const NamedImage& reference,
                                             const std::vector<float>& coverage) {
    std::vector<std::size_t> pixels;
    for (std::size_t p = 0; p < reference.image.pixel_count(); ++p)
        if (coverage.empty() || coverage[p] != 0) pixels.push_back(p);
    if (pixels.empty())
        throw InputError(fmt::format("{}: no pixel shows a surface: A is 0 everywhere", reference.name));
    return pixels;
}

std::optional<std::size_t> coverage_difference(const std::vector<float>& a, const std::vector<float>& b) {
    if (a.empty() || b.empty()) return std::nullopt;
    std::size_t count = 0;
    for (std::size_t p = 0; p < a.size(); ++p) count += (a[p] != 0) != (b[p] != 0);
    return count;
}

}  // namespace

ComparableImages load_comparable(const fs::path& image_file, const fs::path& reference_file) {
    const NamedImage image = read(image_file), reference = read(reference_file);
    check_windows(image, reference);
    const Layer layer = common_layer(image, reference);
    ComparableImages both{
        layer.name, image.window.x, image.window.y, image.window.width, image.window.height, {}, {}, {}, {}};
    both.image = pixels_of(image.image, layer);
    both.reference = pixels_of(reference.image, layer);
    const auto image_coverage = coverage_of(image.image), coverage = coverage_of(reference.image);
    check_finite(not_finite(image, both.image, image_coverage),
                 not_finite(reference, both.reference, coverage));
    both.compared = pixels_with_surface(reference, coverage);
    both.coverage_differs = coverage_difference(image_coverage, coverage);
    return both;
}

}  // namespace common
