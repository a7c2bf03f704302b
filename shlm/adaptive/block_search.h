// Searches the blocks of a whole map: the fewest bytes at a wanted error.
#pragma once

#include "shlm/adaptive/block_choice.h"

namespace shlm {

/// The blocks chosen for a map.
struct MapBlocks {
    std::vector<BlockChoice> face;  ///< in the order of the pyramids
    double error = 0;               ///< AdaptiveMap::estimated_error
};

/// Holds the errors of every block for each kind. Immutable; maps with several errors share it.
class BlockSearch {
  public:
    /// `sums` must have the layout of `texels`.
    BlockSearch(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels, float watts_per_flux);

    /// Returns the smallest map whose estimated error is at most `wanted_error`. If the hits do not allow
    /// that, returns one with an error a twentieth above the least that they allow.
    [[nodiscard]] MapBlocks smallest(double wanted_error) const;

    /// Returns one pyramid for each face of the layout.
    [[nodiscard]] std::span<const LightPyramid> pyramids() const { return pyramid_; }

  private:
    [[nodiscard]] MapBlocks choose_all(double byte_price) const;

    std::vector<LightPyramid> pyramid_;
    std::vector<std::vector<BlockCosts>> costs_;  ///< in the order of the pyramids
    double area_ = 0;                             ///< of all, world units squared
};

}  // namespace shlm
