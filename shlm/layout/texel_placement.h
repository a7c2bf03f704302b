// The number of texels of a light map, and their placement.
#pragma once

#include <cstddef>

namespace shlm {

inline constexpr std::size_t default_texels = 262144;

/// How texels are placed on surfaces.
enum class TexelPlacement {
    automatic,  ///< uv if a surface has coordinates that do not overlap, else face
    uv,         ///< lightmap coordinates; surfaces without them have no texels
    face        ///< the surface's own flat patches; coordinates are ignored
};

}  // namespace shlm
