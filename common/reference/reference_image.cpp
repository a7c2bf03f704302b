#include "common/reference/reference_image.h"

#include <fmt/format.h>

#include <string_view>

#include "common/core/input_error.h"
#include "common/view/render.h"

namespace common::reference {
namespace {

constexpr std::array<const char*, 4> colors = {"irradiance", "variance", "irradiance_low", "variance_low"};
constexpr std::array<const char*, 3> vectors = {"position", "normal", "geometric_normal"};

std::vector<std::string> channel_names() {
    std::vector<std::string> names = {"R", "G", "B", "A"};
    for (const char* color : colors)
        for (const char* channel : {"R", "G", "B"}) names.push_back(fmt::format("{}.{}", color, channel));
    for (const char* vector : vectors)
        for (const char* axis : {"X", "Y", "Z"}) names.push_back(fmt::format("{}.{}", vector, axis));
    return names;
}

ReferencePoint point_of(const VisibleSurface& seen, const std::array<RunningMean, 3>& sums) {
    ReferencePoint point;
    if (!seen.present) return point;
    point.present = true;
    for (int c = 0; c < 3; ++c) {
        point.irradiance[c] = sums[c].mean().high;
        point.irradiance_low[c] = sums[c].mean().low;
        point.variance[c] = sums[c].variance().high;
        point.variance_low[c] = sums[c].variance().low;
    }
    point.position = seen.point.position;
    point.normal = seen.point.shading_normal;
    point.geometric_normal = seen.point.geometric_normal;
    return point;
}

/// Returns the indices of the channels in `image`, in the order of channel_names().
std::vector<std::size_t> find_channels(const std::filesystem::path& file, const Image& image) {
    std::vector<std::size_t> places;
    for (const std::string& name : channel_names()) {
        const auto place = image.find_channel(name);
        if (!place)
            throw InputError(fmt::format("{} is not a reference: it has no channel {}", file.string(), name));
        places.push_back(*place);
    }
    return places;
}

ReferencePoint read_point(const Image& image, std::size_t pixel, std::span<const std::size_t> places) {
    std::size_t next = 3;  // skips R, G, B, which follow from the rest
    const auto number = [&] { return image.at(pixel, places[next++]); };
    const auto read = [&](auto& value) {
        for (int c = 0; c < 3; ++c) value[c] = number();
    };
    ReferencePoint point;
    point.present = number() > 0.5f;
    read(point.irradiance);
    read(point.variance);
    read(point.irradiance_low);
    read(point.variance_low);
    read(point.position);
    read(point.normal);
    read(point.geometric_normal);
    return point;
}

}  // namespace

Image to_image(std::span<const VisibleSurface> pixels, int width, int height, const ReferenceSums& sums) {
    Image image{width, height, channel_names(), {}};
    image.values.reserve(image.pixel_count() * image.channels.size());
    const auto write = [&](const auto& value) {
        for (int c = 0; c < 3; ++c) image.values.push_back(value[c]);
    };
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        const ReferencePoint point = point_of(pixels[p], sums.pixel[p]);
        write(radiance_towards_camera(pixels[p], point.irradiance));
        image.values.push_back(point.present ? 1.0f : 0.0f);
        write(point.irradiance);
        write(point.variance);
        write(point.irradiance_low);
        write(point.variance_low);
        write(point.position);
        write(point.normal);
        write(point.geometric_normal);
    }
    return image;
}

ReferenceImage read_reference(const std::filesystem::path& file) {
    const Image image = read_image(file);
    const std::vector<std::size_t> places = find_channels(file, image);
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        for (const std::size_t channel : places)
            if (!std::isfinite(image.at(p, channel)))
                throw InputError(fmt::format("{}: channel {} is not finite at pixel {}, {}", file.string(),
                                             image.channels[channel], p % image.width, p / image.width));
    ReferenceImage reference{image.width, image.height, {}, read_notes(file)};
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        reference.pixel.push_back(read_point(image, p, places));
        const Rgb& variance = reference.pixel.back().variance;
        if (std::min({variance.x, variance.y, variance.z}) < 0)
            throw InputError(fmt::format("{}: a variance is negative", file.string()));
    }
    return reference;
}

}  // namespace common::reference
