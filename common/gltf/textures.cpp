#include "common/gltf/textures.h"

#include <fmt/format.h>

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

std::string image_name(const tinygltf::Image& image, int index) {
    if (!image.uri.empty()) return image.uri;
    return image.name.empty() ? fmt::format("images/{}", index) : image.name;
}

std::span<const unsigned char> encoded_bytes(const tinygltf::Model& model, const tinygltf::Image& image) {
    return image.bufferView >= 0 ? view_bytes(model, image.bufferView) : std::span(image.image);
}

/// That a texture without an image that is read has one by an extension.
std::string other_images(const tinygltf::Texture& texture) {
    std::string names;
    for (const auto& [name, extension] : texture.extensions)
        names += (names.empty() ? ", only that of " : " and ") + name;
    return names;
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

/// 16 bits are reduced to 8, rounded to nearest: 65535 = 255 * 257.
std::uint8_t byte_of(const tinygltf::Image& image, std::size_t component) {
    if (image.bits != 16) return image.image[component];
    std::uint16_t value;
    std::memcpy(&value, &image.image[2 * component], sizeof value);
    return static_cast<std::uint8_t>((value + 128) / 257);
}

std::vector<std::uint8_t> rgb_of(const tinygltf::Image& image) {
    const auto channels = static_cast<std::size_t>(image.component);
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<std::uint8_t> rgb(3 * pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (std::size_t c = 0; c < 3; ++c) {
            // One or two channels are grey, and grey with alpha.
            const std::size_t channel = channels < 3 ? 0 : c;
            rgb[3 * pixel + c] = byte_of(image, pixel * channels + channel);
        }
    }
    return rgb;
}

}  // namespace

std::int32_t TextureLoader::load(int texture, ColorSpace color_space) {
    const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(texture)];
    // Checked only here: a texture that nothing reads may well have lost its image.
    if (source.source < 0 || static_cast<std::size_t>(source.source) >= model_.images.size())
        throw InputError(
            fmt::format("textures/{} has no PNG or JPEG image{}", texture, other_images(source)));
    tinygltf::Sampler sampler;
    if (source.sampler >= 0) sampler = model_.samplers[static_cast<std::size_t>(source.sampler)];
    const Wrap wrap_u = wrap_of(sampler.wrapS);
    const Wrap wrap_v = wrap_of(sampler.wrapT);

    const auto [entry, is_new] = index_of_use_.try_emplace({source.source, wrap_u, wrap_v, color_space},
                                                           static_cast<std::int32_t>(textures_.size()));
    if (is_new) {
        const tinygltf::Image& image = model_.images[static_cast<std::size_t>(source.source)];
        const std::string name = image_name(image, source.source);
        const tinygltf::Image decoded = decode(encoded_bytes(model_, image), name);
        textures_.emplace_back(name, decoded.width, decoded.height, rgb_of(decoded), color_space, wrap_u,
                               wrap_v);
    }
    return entry->second;
}

}  // namespace common::gltf
