// Converts KHR_lights_punctual to point, spot and directional lights.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends the light of every visible node that has one. Leaves out, with a warning, spot and directional
/// lights under a node whose transform leaves no direction. glTF's photometric values are taken as
/// radiometric ones: candela as W/sr, lux as W/m^2. Throws InputError for a light of unknown type or a
/// negative colour or intensity.
void append_lights(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                   Warnings& warnings);

}  // namespace common::gltf
