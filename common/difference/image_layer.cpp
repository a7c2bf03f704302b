#include "common/difference/image_layer.h"

#include <fmt/ranges.h>

#include "common/core/input_error.h"
#include "common/image/image.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// An image file and its place, for messages.
struct NamedImage {
    std::string name;
    Image image;
};

using Channels = std::array<std::string, 3>;

struct Layer {
    std::string name;
    Channels channels;
};

NamedImage read(const fs::path& file) {
    if (!holds_linear_values(file))
        throw InputError(
            fmt::format("{}: holds display colours; linear values are compared, as in .exr", file.string()));
    return {file.string(), read_image(file)};
}

bool has(const Image& image, const Layer& layer) {
    return std::all_of(layer.channels.begin(), layer.channels.end(),
                       [&](const std::string& channel) { return image.find_channel(channel).has_value(); });
}

void check_sizes(const NamedImage& a, const NamedImage& b) {
    if (a.image.width != b.image.width || a.image.height != b.image.height)
        throw InputError(fmt::format("{} has {} x {} pixels, {} has {} x {}", a.name, a.image.width,
                                     a.image.height, b.name, b.image.width, b.image.height));
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

/// Channel A; empty where there is none.
std::vector<float> coverage_of(const Image& image) {
    const auto place = image.find_channel("A");
    std::vector<float> coverage;
    for (std::size_t p = 0; place && p < image.pixel_count(); ++p) coverage.push_back(image.at(p, *place));
    return coverage;
}

/// How many pixels are not finite and where the first is; empty where all are.
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
                       pixels.size(), first % width, first / width);
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
    check_sizes(image, reference);
    const Layer layer = common_layer(image, reference);
    ComparableImages both{layer.name, image.image.width, image.image.height, {}, {}, {}, {}};
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
