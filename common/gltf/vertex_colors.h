// COLOR_0: what multiplies the base colour of a primitive's material. glTF 2.0, sections 3.7.2.1 and 3.9.2.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// One entry per vertex, in [0, 1], or none where a primitive has no colours or they change nothing.
struct VertexColors {
    std::vector<Rgb> color;    ///< linear
    std::vector<float> alpha;  ///< 1 where the file gives none
};

/// The colours of a primitive named `name` with this material. What is beyond [0, 1] or not finite is mended,
/// with a warning, and so are integers that the file does not call normalized; other sets than the first are
/// left out with one. Throws InputError for a wrong type and for another number than `vertex_count`.
[[nodiscard]] VertexColors read_vertex_colors(const tinygltf::Model& model,
                                              const tinygltf::Primitive& primitive, const Material& material,
                                              std::size_t vertex_count, const std::string& name,
                                              Warnings& warnings);

}  // namespace common::gltf
