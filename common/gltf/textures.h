// Images and samplers of a glTF file -> textures.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "common/scene/texture.h"

namespace common::gltf {

/// Decodes images when something needs them, and each only once for the same use.
class TextureLoader {
  public:
    explicit TextureLoader(const tinygltf::Model& model) : model_(model) {}

    /// Index, into take(), of the model's texture `texture` read as `color_space`. Throws InputError, naming
    /// the image, where there is none or it cannot be read or decoded.
    [[nodiscard]] std::int32_t load(int texture, ColorSpace color_space);

    /// All textures loaded so far.
    [[nodiscard]] std::vector<Texture> take() { return std::move(textures_); }

  private:
    using Use = std::tuple<int, Wrap, Wrap, ColorSpace>;  // the first is the image

    const tinygltf::Model& model_;
    std::map<Use, std::int32_t> index_of_use_;
    std::vector<Texture> textures_;
};

}  // namespace common::gltf
