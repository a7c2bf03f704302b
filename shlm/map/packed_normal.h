// A normal in two 16-bit words, stored beside half floats.
#pragma once

#include <array>

#include "common/core/octahedral.h"

namespace shlm {

/// Packs a normal with an error of at most 0.004 degrees.
[[nodiscard]] inline std::array<std::uint16_t, 2> pack_normal(const common::Vec3& normal) {
    const std::uint32_t packed = common::Octahedral<16>::pack(normal);
    return {static_cast<std::uint16_t>(packed), static_cast<std::uint16_t>(packed >> 16)};
}

[[nodiscard]] inline common::Vec3 unpack_normal(std::uint16_t first, std::uint16_t second) {
    return common::Octahedral<16>::unpack(first | std::uint32_t{second} << 16);
}

}  // namespace shlm
