// The kinds of light that a block of an adaptive map may keep: from nothing to the fit of order 2.
#pragma once

#include "shlm/basis/ambient_and_direction.h"
#include "shlm/basis/luminance_fit.h"

namespace shlm {

enum class BlockKind : std::uint8_t {
    uncovered,  ///< no surface: contributes to no point
    dark,       ///< no light, and no number
    F0,         ///< the surface's irradiance, as uniform light from above
    AD,
    YF2,
    F1,
    F2
};
inline constexpr std::size_t block_kinds = 7;

/// The kinds' names, as used in names of methods.
inline constexpr std::array<const char*, block_kinds> block_kind_names = {"uncovered", "dark", "F0", "AD",
                                                                          "YF2",       "F1",   "F2"};

[[nodiscard]] constexpr bool keeps_numbers(BlockKind kind) {
    return kind > BlockKind::dark;
}

/// The light of a block, W/m^2: the exact irradiance of its surface, and the harmonics that it has summed.
struct BlockLight {
    common::Rgb surface{0, 0, 0};
    TexelLight<2> by_normal{};
};

/// Returns what a basis keeps of a block's light.
template <Basis B>
[[nodiscard]] typename B::Numbers numbers_of(const BlockLight& light, const common::Vec3& face_normal) {
    if constexpr (B::order == 0) {
        return {light.surface.x, light.surface.y, light.surface.z};
    } else {
        TexelLight<B::order> lowest;
        std::copy_n(light.by_normal.begin(), lowest.size(), lowest.begin());
        return B::numbers_of(lowest, face_normal);
    }
}

/// Calls `work` with the basis of a kind that keeps numbers.
template <class Work>
constexpr auto with_basis(BlockKind kind, Work work) {
    switch (kind) {
        case BlockKind::F0:
            return work(HemisphereFit<0>{});
        case BlockKind::AD:
            return work(AmbientAndDirection{});
        case BlockKind::YF2:
            return work(LuminanceFit<2>{});
        case BlockKind::F1:
            return work(HemisphereFit<1>{});
        default:
            return work(HemisphereFit<2>{});
    }
}

/// What a block's light comes from above.
struct BlockFace {
    bool is_flat;         ///< LightPyramid::is_flat
    common::Vec3 normal;  ///< unit
};

/// Returns what to multiply coefficients of irradiance by. On a curved face, light comes also from below the
/// block's mean normal, where a fit over the hemisphere has no bounds: there the plain harmonics answer.
/// `fitted` makes the factors of a flat one.
template <int Order, class Fitted>
[[nodiscard]] ShValues<Order> block_factors(const BlockFace& face, const common::Vec3& shading_normal,
                                            Fitted fitted) {
    return face.is_flat ? fitted() : evaluate_sh<Order>(shading_normal);
}

/// Whether a basis multiplies coefficients of irradiance by such factors.
template <class B>
concept HasFactors = requires(const typename B::Numbers& numbers, const ShValues<B::order>& factors) {
    B::irradiance(numbers, factors);
};

/// Returns the irradiance of what a block keeps, in the unit of its light; may be negative.
template <Basis B>
[[nodiscard]] common::Rgb block_irradiance(const typename B::Numbers& numbers, const BlockFace& face,
                                           const common::Vec3& shading_normal) {
    if constexpr (HasFactors<B>)
        return B::irradiance(numbers, block_factors<B::order>(face, shading_normal, [&] {
                                 return fitted_factors<B::order>(face.normal, shading_normal);
                             }));
    else
        return B::irradiance(numbers, face.normal, typename B::Question(shading_normal));
}

/// Returns the number of floats that a block of a kind keeps.
[[nodiscard]] constexpr std::size_t block_numbers(BlockKind kind) {
    return keeps_numbers(kind) ? with_basis(kind, [](auto basis) { return number_count<decltype(basis)>; })
                               : 0;
}

/// Returns how many of them are in W/m^2; the rest have no unit.
[[nodiscard]] constexpr std::size_t block_light_numbers(BlockKind kind) {
    return keeps_numbers(kind) ? with_basis(kind, [](auto basis) { return decltype(basis)::light_numbers; })
                               : 0;
}

}  // namespace shlm
