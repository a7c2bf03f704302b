// Why the chosen light map is what it is: where its error arises, and what it keeps where.
#pragma once

#include "bench/experiments/fit/search.h"

namespace bench::fit {

/// What one mesh instance adds to the squared error of the choice.
struct SurfaceError {
    std::uint32_t instance = 0;  ///< of the scene
    double points = 0;           ///< share of all points that lie on it
    double noise_sq = 0;         ///< over all surfaces the map's own
    double bias_sq = 0;          ///< blur and truncation; may come out below zero
};

/// A block of the map, or a texel that shows its own hits, as one pixel sees it.
struct SeenBlock {
    std::uint32_t instance = 0;  ///< of the scene
    std::string kind;            ///< what it keeps: a basis, "flat" or "dark"
    float width = 0;             ///< world units
};

struct Explanation {
    std::vector<SurfaceError> surfaces;  ///< the most error first; empty where the choice's error is carried
                                         ///< on from coarser maps
    int width = 0, height = 0;           ///< of the picture
    std::vector<std::optional<SeenBlock>> pixel;  ///< row by row
};

/// Of the light map that was chosen, or comes nearest to the target. Traces it once more with the pilot's
/// seed where its blocks depend on its hits. Throws Stopped, and InputError where there is no such map.
[[nodiscard]] Explanation explain(const FitResult& result, const PilotSubject& subject);

}  // namespace bench::fit
