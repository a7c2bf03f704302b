#include "common/gltf/texture_use.h"

#include <cmath>

#include "common/gltf/extension_values.h"

namespace common::gltf {
namespace {

constexpr const char* extension = "KHR_texture_transform";

Vec2 pair(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

}  // namespace

int texcoord_set(int given, const tinygltf::ExtensionMap& extensions) {
    return static_cast<int>(number_or(extension_object(extensions, extension), "texCoord", given));
}

TexcoordTransform texcoord_transform(const tinygltf::ExtensionMap& extensions) {
    const tinygltf::Value& given = extension_object(extensions, extension);
    const std::vector<double> offset = numbers_or(given, "offset", {0, 0});
    const std::vector<double> scale = numbers_or(given, "scale", {1, 1});
    const double rotation = number_or(given, "rotation", 0);
    // Scales, then rotates, then translates. The matrix in the extension's text rotates in the opposite
    // direction to its words, its example and its test model. The latter are followed.
    const double cosine = std::cos(rotation), sine = std::sin(rotation);
    return {pair(offset[0], offset[1]), pair(cosine * scale[0], -sine * scale[0]),
            pair(sine * scale[1], cosine * scale[1])};
}

}  // namespace common::gltf
