// The interface of a basis, which defines what a finished texel keeps of its light. One file per basis.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "shlm/basis/texel_model.h"

namespace shlm {

/// A basis turns the harmonics that a texel has summed into the numbers that it keeps, and those into
/// irradiance:
///
/// - `order`: of the harmonics that it is made from.
/// - `Numbers`: what is kept, an array of floats. The first `light_numbers` of them are in W/m^2, the others
///   have no unit.
/// - `Question`: made from a shading normal; holds what all texels evaluated for that normal share.
/// - `numbers_of(light, face_normal)`: for a texel whose mean normal is `face_normal`, unit.
/// - `irradiance(numbers, face_normal, question)`: W/m^2; negative values of the truncated series are not
///   clamped here.
/// - `number_name(i)`: the name of number i in a file, LAYER.CHANNEL.
/// - `formula`: irradiance in words, from these layers, the shading normal n and the texel's normal N.
template <class B>
concept Basis = SupportedOrder<B::order> && std::constructible_from<typename B::Question, common::Vec3> &&
    requires(const TexelLight<B::order>& light, const typename B::Numbers& numbers,
             const common::Vec3& face_normal, const typename B::Question& question) {
    { B::light_numbers } -> std::convertible_to<std::size_t>;
    { B::numbers_of(light, face_normal) } -> std::same_as<typename B::Numbers>;
    { B::irradiance(numbers, face_normal, question) } -> std::same_as<common::Rgb>;
    { B::number_name(std::size_t{}) } -> std::same_as<std::string>;
    { B::formula } -> std::convertible_to<std::string_view>;
};

template <Basis B>
inline constexpr std::size_t number_count = std::tuple_size_v<typename B::Numbers>;

/// Returns three of the numbers, from number `first` on.
template <std::size_t Count>
[[nodiscard]] inline common::Rgb rgb_at(const std::array<float, Count>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}
template <std::size_t Count>
inline void set_rgb(std::array<float, Count>& numbers, std::size_t first, const common::Rgb& rgb) {
    for (std::size_t c = 0; c < 3; ++c) numbers[first + c] = rgb[static_cast<int>(c)];
}

/// "own.G" for channel 1 of layer "own".
[[nodiscard]] inline std::string rgb_name(const std::string& layer, std::size_t channel) {
    return layer + "." + "RGB"[channel];
}

}  // namespace shlm
