// Selects the texels that contribute to a point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

namespace shlm {

/// The texel that the point lies in.
struct OwnTexel {};

/// The four texels around the point in the lightmap, those of its chart that face as the point does.
struct Bilinear {};

/// The texels nearest in space that face as the point does.
struct NearestTexels {
    std::size_t count = 4;
    /// If true, only those among them that belong to the point's own surface piece or to one that shares an
    /// edge with it (common::SurfacePieces); if there are none, the nearest that do. If false, whichever are
    /// nearest, as in the paper, even texels of a dark layer a millimetre below.
    bool of_own_surface = true;
};

using Gather = std::variant<OwnTexel, Bilinear, NearestTexels>;

/// Texels in blocks with fewer hits share one light (texel_blocks.h); 0: each shows its own. A block that is
/// just not divided has 25 to 100 hits and the noise of a photon map with 50 nearest photons, its default. A
/// higher number gives less noise and coarser shadows.
inline constexpr std::uint64_t default_least_hits = 100;

}  // namespace shlm
