// Pictures of finished maps.
#pragma once

#include "bench/contenders/trace_into.h"
#include "common/image/image.h"
#include "common/view/visible_surfaces.h"

namespace bench {

/// Renders the map like common::render.
[[nodiscard]] common::Image render_map(const Answers& map, std::span<const common::VisibleSurface> pixels,
                                       int width, int height);

/// Renders the map that a run fills. Returns an empty picture if the run was interrupted.
[[nodiscard]] common::Image render_run(const Contender& contender, PreparedScene& scene, const TracedRun& run,
                                       std::span<const common::VisibleSurface> pixels, int width, int height);

}  // namespace bench
