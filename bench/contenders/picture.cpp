#include "bench/contenders/picture.h"

#include "bench/contenders/direct_light.h"
#include "common/view/render.h"

namespace bench {
namespace {

struct PointByPoint {
    const Answers& map;

    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        common::Rgb answer;
        map.irradiance(std::span(&point, 1), std::span(&answer, 1));
        return answer;
    }
    [[nodiscard]] std::size_t bytes() const { return map.bytes(); }
};

}  // namespace

common::Image render_map(const Answers& map, std::span<const common::VisibleSurface> pixels, int width,
                         int height) {
    return common::render(pixels, width, height, PointByPoint{map});
}

common::Image render_run(const Contender& contender, PreparedScene& scene, const TracedRun& run,
                         std::span<const common::VisibleSurface> pixels, int width, int height) {
    const std::unique_ptr<Store> store = contender->make_store(scene, run.source);
    const common::TraceReport trace = trace_into(*store, run);
    if (trace.interrupted) return {};
    return render_map(*finish_with_direct(contender, *store, trace, scene, run.seed).answers, pixels, width,
                      height);
}

}  // namespace bench
