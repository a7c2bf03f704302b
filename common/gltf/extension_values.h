// Values of the objects that extensions put on materials and textures. Types were checked before
// (check_json.h).
#pragma once

#include <tiny_gltf.h>

#include <vector>

namespace common::gltf {

/// The extension's object, or one without members where it is not used.
[[nodiscard]] const tinygltf::Value& extension_object(const tinygltf::ExtensionMap& extensions,
                                                      const char* extension);

/// The number `key` of `object`, or `missing` where it has none.
[[nodiscard]] double number_or(const tinygltf::Value& object, const char* key, double missing);

/// The list of numbers `key` of `object`, or `missing` where it has none of the same length.
[[nodiscard]] std::vector<double> numbers_or(const tinygltf::Value& object, const char* key,
                                             const std::vector<double>& missing);

/// The textureInfo `key` of `object`; its index is -1 where it has none.
[[nodiscard]] tinygltf::TextureInfo texture_info(const tinygltf::Value& object, const char* key);

}  // namespace common::gltf
