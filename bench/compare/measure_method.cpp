#include "bench/compare/measure_method.h"

#include "bench/app/stopwatch.h"
#include "common/core/memory_use.h"
#include "common/tracer/null_sink.h"

namespace bench {
namespace {

template <class Sink>
common::TraceReport trace_into(Sink& sink, const Workload& w) {
    return common::trace_photons(w.scene.rays, w.source, w.seed, w.target, sink, w.progress);
}

/// Irradiance summed over the points and channels: the sum keeps the compiler from leaving the gathers out.
template <common::IrradianceEstimator Map>
double gather_all(const Map& map, std::span<const common::SurfacePoint> points) {
    double sum = 0;
    for (const common::SurfacePoint& point : points) {
        const common::Rgb irradiance = map.irradiance(point);
        sum += irradiance.x + irradiance.y + irradiance.z;
    }
    return sum;
}

template <class Sink>
Measurement measure(Sink sink, double making_room_seconds, const Workload& w) {
    Measurement m;
    m.making_room_seconds = making_room_seconds;
    m.trace = trace_into(sink, w);
    if (m.trace.interrupted) return m;
    m.rejected = sink.rejected();
    m.insert_bytes = sink.bytes();

    const Stopwatch build;
    const auto map = common::finish_map(std::move(sink), m.trace);
    m.build_seconds = build.seconds();
    m.bytes = map.bytes();

    const Stopwatch gather;
    const double sum = gather_all(map, w.queries.image_order);
    m.gather_seconds = gather.seconds();
    const Stopwatch gather_shuffled;
    const double shuffled_sum = gather_all(map, w.queries.shuffled);
    m.gather_shuffled_seconds = gather_shuffled.seconds();
    m.mean_irradiance = (sum + shuffled_sum) / (6.0 * static_cast<double>(w.queries.image_order.size()));
    m.peak_resident_bytes = common::peak_resident_bytes();
    return m;
}

}  // namespace

Measurement measure_method(const Method& method, PreparedMethods& prepared, const Workload& workload) {
    if (method.light_map()) (void)prepared.texels_of(*method.light_map());  // the scene's, not the run's
    common::reset_peak_resident_bytes();
    const Stopwatch making_room;
    return with_sink(method, prepared, workload.source,
                     [&](auto sink) { return measure(std::move(sink), making_room.seconds(), workload); });
}

common::TraceReport measure_null_sink(const Workload& workload) {
    common::NullSink sink;
    return trace_into(sink, workload);
}

common::Image render_method(const Method& method, PreparedMethods& prepared, const Workload& workload,
                            std::span<const common::VisibleSurface> pixels, int width, int height) {
    return with_sink(method, prepared, workload.source, [&](auto sink) {
        const common::TraceReport trace = trace_into(sink, workload);
        if (trace.interrupted) return common::Image{};
        return common::render(pixels, width, height, common::finish_map(std::move(sink), trace));
    });
}

}  // namespace bench
