// The blocks of a whole map: the fewest bytes at a wanted error.
#pragma once

#include "shlm/adaptive/block_choice.h"

namespace shlm {

/// What was chosen for a map.
struct MapBlocks {
    std::vector<BlockChoice> face;  ///< as the pyramids are
    double error = 0;               ///< AdaptiveMap::estimated_error
};

/// Knows of every block what it costs to keep less of it. Immutable; maps of several errors share it.
class BlockSearch {
  public:
    /// `sums` are of the layout of `texels`.
    BlockSearch(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels, float watts_per_flux);

    /// The smallest map whose estimated error is no more than `wanted_error`; where the hits do not allow
    /// that, one with a twentieth more than the least that they do.
    [[nodiscard]] MapBlocks smallest(double wanted_error) const;

    /// One for each face of the layout.
    [[nodiscard]] std::span<const LightPyramid> pyramids() const { return pyramid_; }

    /// All texels' normals of the face are within a degree: its blocks keep none of their own.
    [[nodiscard]] bool is_flat(std::size_t face) const { return face_[face].flat; }

  private:
    struct Face {
        std::vector<BlockCosts> costs;
        bool flat = false;
    };

    [[nodiscard]] MapBlocks choose_all(double byte_price) const;

    std::vector<LightPyramid> pyramid_;
    std::vector<Face> face_;  ///< as the pyramids are
    double area_ = 0;         ///< of all, world units squared
};

}  // namespace shlm
