// Values of the objects that extensions add to materials and textures. check_json.h has checked their types.
#pragma once

#include <tiny_gltf.h>

#include <vector>

namespace common::gltf {

/// Returns the extension's object, or one without members if it is not used.
[[nodiscard]] const tinygltf::Value& extension_object(const tinygltf::ExtensionMap& extensions,
                                                      const char* extension);

/// Returns the number `key` of `object`, or `missing` if it has none.
[[nodiscard]] double number_or(const tinygltf::Value& object, const char* key, double missing);

/// Returns the list of numbers `key` of `object`, or `missing` if it has none of the same length.
[[nodiscard]] std::vector<double> numbers_or(const tinygltf::Value& object, const char* key,
                                             const std::vector<double>& missing);

/// Returns the textureInfo `key` of `object`; its index is -1 if it has none.
[[nodiscard]] tinygltf::TextureInfo texture_info(const tinygltf::Value& object, const char* key);

}  // namespace common::gltf
