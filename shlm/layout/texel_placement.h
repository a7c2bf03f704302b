// How many texels a light map has, and what they are laid out by.
#pragma once

#include <cstddef>

namespace shlm {

inline constexpr std::size_t default_texels = 262144;

/// What the texels are laid out by.
enum class TexelPlacement {
    automatic,  ///< uv where a surface has coordinates that do not overlap, faces elsewhere
    uv,         ///< lightmap coordinates; surfaces without them have no texels
    face        ///< the surface's own flat pieces; no coordinates are looked at
};

}  // namespace shlm
