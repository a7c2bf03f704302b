// Checks a glTF document's JSON before tinygltf sees it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace common::gltf {

/// Throws InputError unless `document` is glTF 2.x, every property that the loader reads has the type that
/// glTF gives it, every index is in range and every buffer view lies inside its buffer. Missing required
/// properties are left to tinygltf, which reports them.
void check_json(const nlohmann::json& document);

}  // namespace common::gltf
