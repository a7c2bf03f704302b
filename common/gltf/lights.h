// KHR_lights_punctual -> point, spot and directional lights.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends the light of every visible node that has one, but spots and directional lights under a node that
/// has no direction, of which it warns. glTF's photometric numbers are taken as radiometric ones:
/// candela as W/sr, lux as W/m^2. Throws InputError for a light of unknown type or a negative colour or
/// intensity.
void append_lights(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                   Warnings& warnings);

}  // namespace common::gltf
