// COLOR_0: the factors of the base colour of a primitive's material. glTF 2.0, sections 3.7.2.1 and 3.9.2.
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

/// Returns the colours of the vertices `vertices` of a primitive named `name` with this material. Values
/// outside [0, 1] or not finite are corrected, with a warning, and so are integers that the file does not
/// mark as normalized. Sets other than the first are left out, with a warning. Throws InputError for a wrong
/// type and if there are not as many colours as positions.
[[nodiscard]] VertexColors read_vertex_colors(AccessorReader& accessors, const tinygltf::Model& model,
                                              const tinygltf::Primitive& primitive, const Material& material,
                                              std::span<const std::uint32_t> vertices,
                                              const std::string& name, Warnings& warnings);

}  // namespace common::gltf
