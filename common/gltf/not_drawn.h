// What a glTF material asks for that is not drawn.
#pragma once

#include <tiny_gltf.h>

#include <string>

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Adds a warning for each property of `source` that says something and is left out of a surface of `kind`,
/// by its full name. `place` names the material.
void warn_about_what_is_not_drawn(const tinygltf::Material& source, SurfaceKind kind,
                                  const std::string& place, Warnings& warnings);

/// What is said of metals that are not perfect mirrors; glTF's default material is one.
inline constexpr const char* metal_warning = "metal that is not a perfect mirror drawn as Lambertian";

}  // namespace common::gltf
