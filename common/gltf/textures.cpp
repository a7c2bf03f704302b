#include "common/gltf/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/accessor.h"
#include "common/gltf/compression.h"

namespace common::gltf {
namespace {

Wrap wrap_of(int gl_wrap) {
    switch (gl_wrap) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::clamp_to_edge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::mirrored_repeat;
        default:
            return Wrap::repeat;
    }
}

/// Returns linear interpolation if the sampler does not say. minFilter does not matter, as textures are
/// always sampled at full resolution.
Filter filter_of(int gl_mag_filter) {
    return gl_mag_filter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::nearest : Filter::linear;
}

std::string image_name(const tinygltf::Image& image, int index) {
    if (!image.uri.empty() && !image.uri.starts_with("data:")) return image.uri;
    return image.name.empty() ? fmt::format("images/{}", index) : image.name;
}

std::span<const unsigned char> encoded_bytes(const tinygltf::Model& model, const tinygltf::Image& image) {
    return image.bufferView >= 0 ? view_bytes(model, image.bufferView) : std::span(image.image);
}

tinygltf::Image decode(std::span<const unsigned char> encoded, const std::string& name) {
    if (encoded.empty()) throw InputError(fmt::format("image '{}' cannot be read", name));
    tinygltf::Image decoded;
    std::string error, warning;
    bool is_decoded = false;
    if (encoded.size() <= std::numeric_limits<int>::max()) {
        try {
            is_decoded = tinygltf::LoadImageData(&decoded, 0, &error, &warning, 0, 0, encoded.data(),
                                                 static_cast<int>(encoded.size()), nullptr);
        } catch (const std::exception& exception) {
            throw InputError(fmt::format("image '{}' cannot be decoded: {}", name, exception.what()));
        }
    }
    if (!is_decoded) {
        const std::string_view format = foreign_image_format(encoded);
        if (!format.empty())
            throw InputError(fmt::format("image '{}' is {}, which is not read", name, format));
        throw InputError(fmt::format("image '{}' cannot be decoded as PNG or JPEG", name));
    }
    return decoded;
}

/// The components of an image's pixels, which tinygltf decodes to 8 or 16 bits.
class Pixels {
  public:
    explicit Pixels(const tinygltf::Image& image) : image_(image) {}

    [[nodiscard]] bool has_16_bits() const { return image_.bits == 16; }
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height);
    }
    [[nodiscard]] bool has_alpha() const { return image_.component == 2 || image_.component == 4; }

    /// `channel` is 0 to 2; one or two components are grey, and grey with alpha.
    [[nodiscard]] std::uint16_t rgb_16(std::size_t pixel, std::size_t channel) const {
        return component_16(pixel, image_.component < 3 ? 0 : channel);
    }
    [[nodiscard]] std::uint8_t rgb(std::size_t pixel, std::size_t channel) const {
        return component(pixel, image_.component < 3 ? 0 : channel);
    }
    [[nodiscard]] std::uint8_t alpha(std::size_t pixel) const {
        return component(pixel, static_cast<std::size_t>(image_.component) - 1);
    }

  private:
    [[nodiscard]] std::size_t place(std::size_t pixel, std::size_t component) const {
        return pixel * static_cast<std::size_t>(image_.component) + component;
    }
    [[nodiscard]] std::uint16_t component_16(std::size_t pixel, std::size_t component) const {
        std::uint16_t value;
        std::memcpy(&value, &image_.image[2 * place(pixel, component)], sizeof value);
        return value;
    }
    /// 16 bits are reduced to 8, rounded to nearest: 65535 = 255 * 257.
    [[nodiscard]] std::uint8_t component(std::size_t pixel, std::size_t component) const {
        if (!has_16_bits()) return image_.image[place(pixel, component)];
        return static_cast<std::uint8_t>((component_16(pixel, component) + 128) / 257);
    }

    const tinygltf::Image& image_;
};

std::vector<std::uint8_t> rgb_of(const Pixels& pixels) {
    std::vector<std::uint8_t> rgb(3 * pixels.count());
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = pixels.rgb(i / 3, i % 3);
    return rgb;
}

std::vector<std::uint16_t> rgb_16_of(const Pixels& pixels) {
    if (!pixels.has_16_bits()) return {};
    std::vector<std::uint16_t> rgb(3 * pixels.count());
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = pixels.rgb_16(i / 3, i % 3);
    return rgb;
}

/// Returns nothing if alpha is 1 everywhere.
std::vector<std::uint8_t> alpha_of(const Pixels& pixels) {
    if (!pixels.has_alpha()) return {};
    std::vector<std::uint8_t> alpha(pixels.count());
    for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = pixels.alpha(i);
    const bool is_opaque = std::all_of(alpha.begin(), alpha.end(), [](std::uint8_t a) { return a == 255; });
    return is_opaque ? std::vector<std::uint8_t>() : alpha;
}

/// Returns the message for a texture without a readable image, naming the extensions that have another.
std::string no_image(const tinygltf::Texture& source, int texture) {
    std::string others;
    for (const auto& [name, object] : source.extensions) {
        if (object.Has("source")) others += (others.empty() ? ", only one of " : " and ") + name;
    }
    return fmt::format("textures/{} has no PNG or JPEG image{}", texture, others);
}

}  // namespace

std::int32_t TextureLoader::load(int texture, ColorSpace color_space, Alpha alpha) {
    const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(texture)];
    // Checked only here: a texture that nothing reads may well have lost its image.
    if (source.source < 0 || static_cast<std::size_t>(source.source) >= model_.images.size())
        throw InputError(no_image(source, texture));
    tinygltf::Sampler sampler;
    if (source.sampler >= 0) sampler = model_.samplers[static_cast<std::size_t>(source.sampler)];
    const Use use{source.source, wrap_of(sampler.wrapS), wrap_of(sampler.wrapT), filter_of(sampler.magFilter),
                  color_space};

    const auto [entry, is_new] = index_of_use_.try_emplace(use, static_cast<std::int32_t>(textures_.size()));
    const auto index = static_cast<std::size_t>(entry->second);
    if (is_new) {
        textures_.push_back(decode_for(use, alpha));
        alpha_of_.push_back(alpha);
    } else if (alpha == Alpha::kept && alpha_of_[index] == Alpha::left_out) {
        textures_[index] = decode_for(use, alpha);
        alpha_of_[index] = alpha;
    }
    return entry->second;
}

Texture TextureLoader::decode_for(const Use& use, Alpha alpha) const {
    const auto& [index, wrap_u, wrap_v, filter, color_space] = use;
    const tinygltf::Image& image = model_.images[static_cast<std::size_t>(index)];
    const std::string name = image_name(image, index);
    const tinygltf::Image decoded = decode(encoded_bytes(model_, image), name);
    const Pixels pixels(decoded);
    return {
        name,           decoded.width,
        decoded.height, rgb_of(pixels),
        color_space,    wrap_u,
        wrap_v,         alpha == Alpha::kept ? alpha_of(pixels) : std::vector<std::uint8_t>(),
        filter,         color_space == ColorSpace::linear ? rgb_16_of(pixels) : std::vector<std::uint16_t>()};
}

}  // namespace common::gltf
