#include "common/scene/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/core/input_error.h"

namespace common {
namespace {

/// IEC 61966-2-1.
float linear_of_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// Returns the place in [0, 1] to which `coordinate` wraps. Wrapping before the multiplication by the size
/// lets an int count texels, however large a coordinate is.
float wrapped(float coordinate, Wrap wrap) {
    if (!std::isfinite(coordinate)) return 0;
    switch (wrap) {
        case Wrap::repeat:
            return coordinate - std::floor(coordinate);
        case Wrap::mirrored_repeat: {
            const float in_period = coordinate - 2 * std::floor(coordinate / 2);
            return in_period <= 1 ? in_period : 2 - in_period;
        }
        case Wrap::clamp_to_edge:
            break;
    }
    return std::clamp(coordinate, 0.0f, 1.0f);
}

/// Two neighbouring texels along one axis and the weight of the second.
struct Texels {
    int first, second;
    float weight;
};

/// Returns the texels around a coordinate. Texel centres are at half-integers, so a place at the edge lies
/// between the last texel and the one that wrapping puts beyond it. That is the other end for repeat, the
/// last texel itself otherwise.
Texels texels_around(float coordinate, int size, Wrap wrap) {
    const float place = wrapped(coordinate, wrap) * static_cast<float>(size) - 0.5f;
    const int index = place < 0 ? -1 : static_cast<int>(place);  // avoids a call of std::floor
    const auto inside = [&](int i) {
        if (i < 0) return wrap == Wrap::repeat ? size - 1 : 0;
        if (i >= size) return wrap == Wrap::repeat ? i - size : size - 1;
        return i;
    };
    return {inside(index), inside(index + 1), place - static_cast<float>(index)};
}

/// Returns the sum of `value` over the four texels, by their weights.
template <class Value>
auto weighted(const Texture::Footprint& around, const Value& value) {
    const auto& [upper_left, upper_right, lower_left, lower_right] = around.texel;
    const float left = 1 - around.right;
    const auto upper = value(upper_left) * left + value(upper_right) * around.right;
    const auto lower = value(lower_left) * left + value(lower_right) * around.right;
    return upper * (1 - around.lower) + lower * around.lower;
}

}  // namespace

Texture::Texture(std::string name, int width, int height, std::vector<std::uint8_t> rgb,
                 ColorSpace color_space, Wrap wrap_u, Wrap wrap_v, std::vector<std::uint8_t> alpha,
                 Filter filtering, std::vector<std::uint16_t> rgb_16)
    : name_(std::move(name)),
      width_(width),
      height_(height),
      rgb_(std::move(rgb)),
      alpha_(std::move(alpha)),
      rgb_16_(std::move(rgb_16)),
      color_space_(color_space),
      wrap_u_(wrap_u),
      wrap_v_(wrap_v),
      filtering_(filtering) {
    if (width < 1 || height < 1 ||
        rgb_.size() / 3 / static_cast<std::size_t>(width) != static_cast<std::size_t>(height) ||
        rgb_.size() % (3 * static_cast<std::size_t>(width)) != 0 ||
        (!alpha_.empty() && alpha_.size() != rgb_.size() / 3) ||
        (!rgb_16_.empty() && (rgb_16_.size() != rgb_.size() || color_space != ColorSpace::linear)))
        throw InputError(fmt::format("image '{}' does not have {} x {} RGB pixels", name_, width, height));
    for (std::size_t byte = 0; byte < linear_of_byte_.size(); ++byte) {
        const float value = static_cast<float>(byte) / 255.0f;
        linear_of_byte_[byte] = color_space == ColorSpace::srgb ? linear_of_srgb(value) : value;
    }
}

Texture::Footprint Texture::footprint(Vec2 texcoord) const {
    const Texels u = texels_around(texcoord.x, width_, wrap_u_);
    const Texels v = texels_around(texcoord.y, height_, wrap_v_);
    const auto byte_of = [this](int x, int y) {
        return 3 *
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
    };
    // The nearest pixel is the one of the two with the larger weight.
    const auto weight_of = [this](const Texels& texels) {
        if (filtering_ == Filter::linear) return texels.weight;
        return texels.weight < 0.5f ? 0.0f : 1.0f;
    };
    return {{byte_of(u.first, v.first), byte_of(u.second, v.first), byte_of(u.first, v.second),
             byte_of(u.second, v.second)},
            weight_of(u),
            weight_of(v)};
}

Rgb Texture::filter(const Footprint& around) const {
    return weighted(around, [this](std::size_t texel) { return linear(texel); });
}

Rgb Texture::filter_16(const Footprint& around) const {
    return weighted(around, [this](std::size_t texel) { return linear_16(texel); });
}

float Texture::sample_alpha(Vec2 texcoord) const {
    if (alpha_.empty()) return 1;
    return weighted(footprint(texcoord),
                    [this](std::size_t texel) { return static_cast<float>(alpha_[texel / 3]) / 255.0f; });
}

}  // namespace common
