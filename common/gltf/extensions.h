// Which glTF extensions are understood.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/gltf/warnings.h"

namespace common::gltf {

/// Throws InputError, naming it, for an extension that the file requires and that is not drawn; adds a
/// warning for each one that is listed or used somewhere and not drawn, with its whole name.
void check_extensions(const nlohmann::json& document, Warnings& warnings);

}  // namespace common::gltf
