// The kinds of light that a block of an adaptive map may keep: from nothing to order 2.
#pragma once

#include "shlm/basis/ambient_and_direction.h"
#include "shlm/basis/harmonics.h"
#include "shlm/basis/hemisphere_four.h"
#include "shlm/basis/luminance_nine.h"

namespace shlm {

enum class BlockKind : std::uint8_t {
    uncovered,  ///< no surface: contributes to no point
    dark,       ///< no light, and no number
    flat,       ///< the surface's irradiance, for all normals
    AD,
    H4,
    YL2,
    L2
};
inline constexpr std::size_t block_kinds = 7;

/// The kinds' names, as used in names of methods.
inline constexpr std::array<const char*, block_kinds> block_kind_names = {"uncovered", "dark", "flat", "AD",
                                                                          "H4",        "YL2",  "L2"};

/// The number of floats that a block of each kind keeps.
inline constexpr std::array<std::size_t, block_kinds> block_numbers = {0,
                                                                       0,
                                                                       3,
                                                                       number_count<AmbientAndDirection>,
                                                                       number_count<HemisphereFour>,
                                                                       number_count<LuminanceNine>,
                                                                       number_count<Harmonics<2>>};

/// The light of a block, W/m^2: the exact irradiance of its surface, and the irradiance by normal.
struct BlockLight {
    common::Rgb surface{0, 0, 0};
    TexelLight<2> by_normal{};
};

/// Returns what a basis keeps of a block's light.
template <Basis B>
[[nodiscard]] typename B::Numbers numbers_of(const BlockLight& light, const common::Vec3& face_normal) {
    TexelLight<B::order> lowest;
    std::copy_n(light.by_normal.begin(), lowest.size(), lowest.begin());
    return B::numbers_of(lowest, face_normal);
}

/// Calls `work` with the basis of a kind whose irradiance depends on the normal.
template <class Work>
auto with_directional_basis(BlockKind kind, Work work) {
    switch (kind) {
        case BlockKind::AD:
            return work(AmbientAndDirection{});
        case BlockKind::H4:
            return work(HemisphereFour{});
        case BlockKind::YL2:
            return work(LuminanceNine{});
        default:
            return work(Harmonics<2>{});
    }
}

/// Returns how many of the numbers are in W/m^2; the rest have no unit.
[[nodiscard]] inline std::size_t block_light_numbers(BlockKind kind) {
    return kind <= BlockKind::flat
               ? block_numbers[static_cast<std::size_t>(kind)]
               : with_directional_basis(kind, [](auto basis) { return decltype(basis)::light_numbers; });
}

}  // namespace shlm
