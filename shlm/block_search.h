// The blocks of a whole map: the fewest bytes at a wanted error.
#pragma once

#include "shlm/block_choice.h"

namespace shlm {

/// What is known of one face's blocks, and what was chosen.
struct FaceBlocks {
    std::vector<BlockCosts> costs;
    bool flat = false;  ///< all its texels' normals are within a degree: blocks keep none of their own
    BlockChoice choice;
};

struct MapBlocks {
    std::vector<FaceBlocks> face;  ///< as the pyramids are
    double error = 0;              ///< AdaptiveMap::estimated_error
};

/// The smallest map whose estimated error is no more than `wanted_error`; where the hits do not allow that,
/// one with a twentieth more than the least that they do. `normals`: one per region of the layout.
[[nodiscard]] MapBlocks search_blocks(std::span<const LightPyramid> pyramids,
                                      std::span<const NormalsInUse> normals, double wanted_error);

}  // namespace shlm
