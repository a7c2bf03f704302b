// One channel of a texel's light, and the mean of its channels.
#pragma once

#include "shlm/basis/texel_model.h"

namespace shlm {

/// Returns channel c of harmonics.
template <std::size_t Count>
[[nodiscard]] inline std::array<float, Count> channel_of(const std::array<common::Rgb, Count>& light, int c) {
    std::array<float, Count> channel;
    for (std::size_t i = 0; i < Count; ++i) channel[i] = light[i][c];
    return channel;
}

/// Returns the mean of the channels, whose shape stands for all three where only one shape is kept.
template <std::size_t Count>
[[nodiscard]] inline std::array<float, Count> grey_of(const std::array<common::Rgb, Count>& light) {
    std::array<float, Count> grey;
    for (std::size_t i = 0; i < Count; ++i) grey[i] = common::mean_component(light[i]);
    return grey;
}

}  // namespace shlm
