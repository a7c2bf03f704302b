// The 64-bit hash FNV-1a (Fowler, Noll, Vo): fast, the same on every machine, not cryptographic.
#pragma once

#include <cstdint>

namespace common {

inline constexpr std::uint64_t fnv_start = 0xcbf29ce484222325;

/// Returns the hash after one more value. In the published hash a value is one byte.
[[nodiscard]] constexpr std::uint64_t fnv_step(std::uint64_t hash, std::uint64_t value) {
    return (hash ^ value) * 0x100000001b3;
}

}  // namespace common
