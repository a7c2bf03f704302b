#include "bench/compare/measure_method.h"

#include <fmt/format.h>

#include <new>

#include "bench/app/finished_map.h"
#include "common/core/memory_use.h"
#include "common/core/stopwatch.h"
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

std::string past_its_bound(const Workload& w, std::uint64_t hits) {
    return fmt::format("grew past --max-memory, {:.3g} GiB, at {:.3g} hits",
                       static_cast<double>(w.max_bytes) * 0x1p-30, static_cast<double>(hits));
}

/// Asks the finished map for all queries, in both orders.
template <common::IrradianceEstimator Map>
void measure_gather(const Map& map, const Workload& w, Measurement& m) {
    const common::Stopwatch gather;
    const double sum = gather_all(map, w.queries.image_order);
    m.gather_seconds = gather.seconds();
    const common::Stopwatch gather_shuffled;
    const double shuffled_sum = gather_all(map, w.queries.shuffled);
    m.gather_shuffled_seconds = gather_shuffled.seconds();
    m.mean_irradiance = (sum + shuffled_sum) / (6.0 * static_cast<double>(w.queries.image_order.size()));
    m.peak_resident_bytes = common::peak_resident_bytes();
}

template <class Sink>
void measure(const Method& method, Sink sink, const Workload& w, Measurement& m) {
    const auto too_large = [&] {
        const std::size_t now = common::resident_bytes();
        return now > m.resident_before_bytes && now - m.resident_before_bytes > w.max_bytes;
    };
    Workload watched = w;
    watched.progress = [&](const common::TraceReport& so_far) {
        if (too_large()) m.given_up = past_its_bound(w, so_far.hits);
        return m.given_up.empty() && (!w.progress || w.progress(so_far));
    };
    m.trace = trace_into(sink, watched);
    if (m.trace.interrupted) return;
    m.rejected = sink.rejected();
    m.insert_bytes = sink.bytes();

    const common::Stopwatch build;
    const auto map = finished_map(method, std::move(sink), m.trace);
    m.build_seconds = build.seconds();
    m.bytes = map.bytes();
    if (too_large()) {
        m.given_up = past_its_bound(w, m.trace.hits);
        m.trace.interrupted = true;
        return;
    }
    measure_gather(map, w, m);
}

}  // namespace

Measurement measure_method(const Method& method, PreparedMethods& prepared, const Workload& workload) {
    prepared.prepare(method);  // the scene's, not the run's
    Measurement m;
    m.peak_is_of_this_run = common::reset_peak_resident_bytes();
    m.resident_before_bytes = common::resident_bytes();
    try {
        const common::Stopwatch making_room;
        with_sink(method, prepared, workload.source, [&](auto sink) {
            m.making_room_seconds = making_room.seconds();
            measure(method, std::move(sink), workload, m);
        });
    } catch (const std::bad_alloc&) {
        m.given_up = "found no more memory";
        m.trace.interrupted = true;
    }
    return m;
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
        return common::render(pixels, width, height, finished_map(method, std::move(sink), trace));
    });
}

}  // namespace bench
