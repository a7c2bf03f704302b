// Which texels answer for a point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

namespace shlm {

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

/// Texels in blocks of fewer hits share one light (texel_blocks.h); 0: each shows its own. A block that just
/// misses being divided has 25 to 100 hits and the noise of a photon map's 50 nearest, its default. More
/// bring less noise and coarser shadows.
inline constexpr std::uint64_t default_least_hits = 100;

}  // namespace shlm
