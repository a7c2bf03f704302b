// A short text that tells two scenes apart.
#pragma once

#include <string>

#include "common/scene/scene.h"

namespace common {

/// 16 hexadecimal digits over geometry, materials, textures and lights: FNV-1a, 64 bits (Fowler, Noll and Vo,
/// "The FNV Non-Cryptographic Hash Algorithm", RFC 9923), over the values as they lie in memory. Names,
/// cameras and the file's place do not count. The same on any machine with the same byte order.
[[nodiscard]] std::string fingerprint(const Scene& scene);

}  // namespace common
