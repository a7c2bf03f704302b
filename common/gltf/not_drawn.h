// Properties of glTF materials that are not drawn.
#pragma once

#include <tiny_gltf.h>

#include <string>

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Adds a warning, with the full name, for each property of `source` that has an effect and is left out of a
/// surface of `kind`. `place` names the material.
void warn_about_what_is_not_drawn(const tinygltf::Material& source, SurfaceKind kind,
                                  const std::string& place, Warnings& warnings);

/// The warning for metals that are not perfect mirrors; glTF's default material is one.
inline constexpr const char* metal_warning = "metal that is not a perfect mirror drawn as Lambertian";

}  // namespace common::gltf
