// Which glTF extensions are understood.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/gltf/warnings.h"

namespace common::gltf {

/// Throws InputError, naming it, for an extension that the file requires and that is not known here; adds a
/// warning for each one that is used and ignored.
void check_extensions(const nlohmann::json& document, Warnings& warnings);

}  // namespace common::gltf
