// Converts images and samplers of a glTF file to textures.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "common/scene/texture.h"

namespace common::gltf {

/// Whether an image's alpha channel is kept.
enum class Alpha { left_out, kept };

/// Decodes images on demand, each only once for the same use.
class TextureLoader {
  public:
    explicit TextureLoader(const tinygltf::Model& model) : model_(model) {}

    /// Returns the index, into take(), of the model's texture `texture` read as `color_space`. Data keep 16
    /// bits if the image has them, colours 8. Throws InputError, naming the image, if there is none or if it
    /// cannot be read or decoded.
    [[nodiscard]] std::int32_t load(int texture, ColorSpace color_space, Alpha alpha);

    /// All textures loaded so far.
    [[nodiscard]] std::vector<Texture> take() { return std::move(textures_); }

  private:
    using Use = std::tuple<int, Wrap, Wrap, Filter, ColorSpace>;  // the first is the image

    [[nodiscard]] Texture decode_for(const Use& use, Alpha alpha) const;

    const tinygltf::Model& model_;
    std::map<Use, std::int32_t> index_of_use_;
    std::vector<Texture> textures_;
    std::vector<Alpha> alpha_of_;  ///< of each texture
};

}  // namespace common::gltf
