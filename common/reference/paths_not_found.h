// What the reference leaves out of a scene's light.
#pragma once

#include <string>

#include "common/scene/scene.h"

namespace common::reference {

/// Light that no path finds, in words: a light without size cannot be met by chance, and no straight line
/// leads to it through a mirror or glass. Empty where every path is found.
[[nodiscard]] std::string paths_not_found(const Scene& scene);

}  // namespace common::reference
