// How a light map is laid out, filled and asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

namespace shlm {

/// What directional light a hit of flux F, on texel area a, at incidence theta stands for. The paper leaves
/// it open.
enum class ShWeight {
    radiance,   ///< F / (a cos theta): its irradiance on the surface is F / a, as it must be
    flux,       ///< F / a: the paper read literally; reads two thirds of a uniform hemisphere
    normalised  ///< as radiance, but only for the shape: scaled so that the surface's own normal gets the
                ///< exact sum of F / a, which is kept as one more number
};

/// The texel that the point lies in.
struct OwnTexel {};

/// The four texels around the point in the lightmap, those of its chart that look its way.
struct Bilinear {};

/// The texels nearest in space that look the point's way.
struct NearestTexels {
    std::size_t count = 4;
    /// Only those among them that are of the point's own piece of surface or of a piece that shares an edge
    /// with it (common::SurfacePieces); where there is none, the nearest that are. Otherwise whichever are
    /// nearest, as in the paper: texels of a dark layer a millimetre below, too.
    bool of_own_surface = true;
};

using Gather = std::variant<OwnTexel, Bilinear, NearestTexels>;

inline constexpr std::size_t default_texels = 262144;

/// What the texels are laid out by.
enum class TexelPlacement {
    automatic,  ///< uv where a surface has coordinates that do not overlap, faces elsewhere
    uv,         ///< lightmap coordinates; surfaces without them have no texels
    face        ///< the surface's own flat pieces; no coordinates are looked at
};

/// Texels in blocks of fewer hits share one light (texel_blocks.h); 0: each shows its own. A block that just
/// misses being divided has 25 to 100 hits and the noise of a photon map's 50 nearest, its default. More
/// bring less noise and coarser shadows.
inline constexpr std::uint64_t default_least_hits = 100;

}  // namespace shlm
