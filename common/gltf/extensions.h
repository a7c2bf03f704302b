// The glTF extensions that are supported.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/gltf/warnings.h"

namespace common::gltf {

/// Throws InputError, naming the extension, if the file requires one that is not drawn. Adds a warning, with
/// the full name, for each extension that is listed or used anywhere and not drawn.
void check_extensions(const nlohmann::json& document, Warnings& warnings);

}  // namespace common::gltf
