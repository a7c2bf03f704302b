// Explains the chosen light map: on which surfaces its error arises, and what it keeps there.
#pragma once

#include "bench/experiments/fit/search.h"

namespace bench::fit {

/// The contribution of one mesh instance to the squared error of the choice.
struct SurfaceError {
    std::uint32_t instance = 0;  ///< of the scene
    double points = 0;           ///< fraction of all points that lie on it
    double noise_sq = 0;         ///< variance; the sum over all surfaces is the map's
    double bias_sq = 0;          ///< blur and truncation; the estimate may be negative
};

/// A block of an adaptive map, or a texel that shows its own hits, as one pixel sees it.
struct SeenBlock {
    std::uint32_t instance = 0;  ///< of the scene
    std::string kind;            ///< what it keeps: a basis, "flat" or "dark"
    float width = 0;             ///< scene units
};

struct Explanation {
    std::vector<SurfaceError> surfaces;  ///< most error first; empty where the error of the choice is
                                         ///< extrapolated from coarser maps
    int width = 0, height = 0;           ///< of the picture
    std::vector<std::optional<SeenBlock>> pixel;  ///< row by row
};

/// Explains the light map that was chosen, or the one that comes nearest to the target. If its blocks depend
/// on its hits, it is traced once more with the pilot's seed. Throws Stopped, and InputError where there is
/// no such map.
[[nodiscard]] Explanation explain(const FitResult& result, const PilotSubject& subject);

}  // namespace bench::fit
