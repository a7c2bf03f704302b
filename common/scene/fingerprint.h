// A short text that identifies a scene.
#pragma once

#include <string>

#include "common/scene/scene.h"

namespace common {

/// Returns 16 hexadecimal digits, a hash of geometry, materials, textures and lights: FNV-1a, 64 bits
/// (Fowler, Noll and Vo, "The FNV Non-Cryptographic Hash Algorithm", RFC 9923), over the values in memory.
/// Names, cameras and the file's location do not count. It is the same on all machines with the same byte
/// order.
[[nodiscard]] std::string fingerprint(const Scene& scene);

}  // namespace common
