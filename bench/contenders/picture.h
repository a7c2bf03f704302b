// A picture of a finished map.
#pragma once

#include "bench/contenders/trace_into.h"
#include "common/image/image.h"
#include "common/view/visible_surfaces.h"

namespace bench {

/// As common::render.
[[nodiscard]] common::Image render_map(const Answers& map, std::span<const common::VisibleSurface> pixels,
                                       int width, int height);

/// Of the map that a run fills; an empty one where it was interrupted.
[[nodiscard]] common::Image render_run(const Contender& contender, PreparedScene& scene, const TracedRun& run,
                                       std::span<const common::VisibleSurface> pixels, int width, int height);

}  // namespace bench
