// An image sampled at texture coordinates, as glTF defines its samplers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common {

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };

/// Interpolation between the centres of pixels.
enum class Filter {
    linear,  ///< bilinear, of the four pixels around
    nearest  ///< the nearest pixel
};

enum class ColorSpace {
    linear,  ///< data: normal maps
    srgb     ///< colours: base colour and emission; decoded to linear when sampled
};

/// An RGB image of 8 bits, some with alpha; some images of data have 16 bits. Row 0 is the top row, at v = 0
/// (glTF 2.0, section 3.8.1).
class Texture {
  public:
    /// `rgb` holds 3 * width * height bytes, row by row; `alpha` a third of that, or none if it is 1
    /// everywhere. `rgb_16` holds the values that `rgb` was rounded from, in 65535ths, or none; it is only
    /// for data. Throws InputError if that does not hold.
    Texture(std::string name, int width, int height, std::vector<std::uint8_t> rgb, ColorSpace color_space,
            Wrap wrap_u, Wrap wrap_v, std::vector<std::uint8_t> alpha = {}, Filter filtering = Filter::linear,
            std::vector<std::uint16_t> rgb_16 = {});

    /// The four texels around a place and their weights.
    struct Footprint {
        std::array<std::size_t, 4>
            texel;           ///< first byte of each: upper left, upper right, lower left, lower right
        float right, lower;  ///< weights, in [0, 1]
    };

    /// Returns the filtered sample at `texcoord`; linear values in [0, 1].
    [[nodiscard]] Rgb sample(Vec2 texcoord) const {
        return rgb_16_.empty() ? filter(footprint(texcoord)) : filter_16(footprint(texcoord));
    }

    // The same in two steps, so that callers with many samples can prefetch what the second step reads. This
    // uses 8 bits, even if the image has 16.
    [[nodiscard]] Footprint footprint(Vec2 texcoord) const;
    void prefetch(const Footprint& around) const {
        __builtin_prefetch(&rgb_[around.texel[0]]);
        __builtin_prefetch(&rgb_[around.texel[2]]);
    }
    [[nodiscard]] Rgb filter(const Footprint& around) const;

    /// Returns the filtered sample of alpha, in [0, 1].
    [[nodiscard]] float sample_alpha(Vec2 texcoord) const;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::span<const std::uint8_t> rgb() const { return rgb_; }
    [[nodiscard]] bool has_alpha() const { return !alpha_.empty(); }
    [[nodiscard]] std::span<const std::uint8_t> alpha() const { return alpha_; }
    [[nodiscard]] std::span<const std::uint16_t> rgb_16() const { return rgb_16_; }
    [[nodiscard]] ColorSpace color_space() const { return color_space_; }
    [[nodiscard]] std::array<Wrap, 2> wrap() const { return {wrap_u_, wrap_v_}; }
    [[nodiscard]] Filter filtering() const { return filtering_; }
    [[nodiscard]] std::size_t bytes() const {
        return rgb_.capacity() + alpha_.capacity() + sizeof(std::uint16_t) * rgb_16_.capacity();
    }

  private:
    [[nodiscard]] Rgb filter_16(const Footprint& around) const;
    [[nodiscard]] Rgb linear(std::size_t texel) const {
        return {linear_of_byte_[rgb_[texel]], linear_of_byte_[rgb_[texel + 1]],
                linear_of_byte_[rgb_[texel + 2]]};
    }
    [[nodiscard]] Rgb linear_16(std::size_t texel) const {
        return Rgb(rgb_16_[texel], rgb_16_[texel + 1], rgb_16_[texel + 2]) / 65535.0f;
    }

    std::string name_;
    int width_, height_;
    std::vector<std::uint8_t> rgb_;
    std::vector<std::uint8_t> alpha_;    ///< none if it is 1 everywhere
    std::vector<std::uint16_t> rgb_16_;  ///< none if the image has 8 bits
    std::array<float, 256> linear_of_byte_;
    ColorSpace color_space_;
    Wrap wrap_u_, wrap_v_;
    Filter filtering_;
};

}  // namespace common
