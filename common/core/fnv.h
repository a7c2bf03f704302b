// The hash FNV-1a of 64 bits (Fowler, Noll, Vo): quick, the same everywhere, and no secret.
#pragma once

#include <cstdint>

namespace common {

inline constexpr std::uint64_t fnv_start = 0xcbf29ce484222325;

/// The hash with one more value, a byte in the published hash.
[[nodiscard]] constexpr std::uint64_t fnv_step(std::uint64_t hash, std::uint64_t value) {
    return (hash ^ value) * 0x100000001b3;
}

}  // namespace common
