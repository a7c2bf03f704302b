// COLOR_0: what multiplies the base colour of a primitive's material. glTF 2.0, sections 3.7.2.1 and 3.9.2.
#pragma once

#include <tiny_gltf.h>

#include <span>
#include <string>
#include <vector>

#include "common/gltf/accessor.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// One entry per vertex, in [0, 1], or none where a primitive has no colours or they change nothing.
struct VertexColors {
    std::vector<Rgb> color;    ///< linear
    std::vector<float> alpha;  ///< 1 where the file gives none
};

/// The colours of the vertices `vertices` of a primitive named `name` with this material. What is beyond [0,
/// 1] or not finite is mended, with a warning, and so are integers that the file does not call normalized;
/// other sets than the first are left out with one. Throws InputError for a wrong type and where there are
/// not as many as positions.
[[nodiscard]] VertexColors read_vertex_colors(AccessorReader& accessors, const tinygltf::Model& model,
                                              const tinygltf::Primitive& primitive, const Material& material,
                                              std::span<const std::uint32_t> vertices,
                                              const std::string& name, Warnings& warnings);

}  // namespace common::gltf
