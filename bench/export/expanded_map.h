// An adaptive map as texels, for programs that know no blocks.
#pragma once

#include "bench/contenders/light_map.h"
#include "shlm/adaptive/adaptive_map.h"

namespace bench {

/// Texels of F2, as large in each region as the region's smallest block.
struct ExpandedMap {
    static constexpr const char* basis = "F2";
    shlm::TexelLayout layout;
    StoredTexels texels;

    /// Returns the bytes that a map of these texels takes: halves, packed normals and places.
    [[nodiscard]] std::size_t bytes() const;
};

/// Reads the map at the middle of each texel. Texels whose block has a surface all weigh alike; the others
/// have no area. `layout` is that of the map, `store` that of its sums.
[[nodiscard]] ExpandedMap expand(const shlm::AdaptiveMap& map, const shlm::TexelLayout& layout,
                                 const LightMapStore& store);

/// Returns what a program reads there that filters as shlm::Bilinear does. Keeps a reference to `map`.
[[nodiscard]] std::unique_ptr<const Answers> answers_of_texels(const ExpandedMap& map);

}  // namespace bench
