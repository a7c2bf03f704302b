#include "bench/experiments/compare/measure_method.h"

#include <fmt/format.h>

#include <new>

#include "bench/contenders/direct_light.h"
#include "bench/contenders/trace_into.h"
#include "common/core/memory_use.h"
#include "common/core/stopwatch.h"

namespace bench::compare {
namespace {

TracedRun run_of(const Workload& w, const common::TraceProgress& progress) {
    return {w.scene.rays, w.source, w.seed, w.target, progress, {}, w.recorded};
}

double sum_of(std::span<const common::Rgb> answers) {
    double sum = 0;
    for (const common::Rgb& irradiance : answers) sum += irradiance.x + irradiance.y + irradiance.z;
    return sum;
}

std::string past_its_bound(const Workload& w, std::uint64_t hits) {
    return fmt::format("grew past --max-memory, {:.3g} GiB, at {:.3g} hits",
                       static_cast<double>(w.max_bytes) * 0x1p-30, static_cast<double>(hits));
}

/// Evaluates the finished map at all queries, in both orders.
void measure_gather(const Answers& map, const Workload& w, Measurement& m) {
    // Touch the pages here, so that the first touch is not timed as part of a gather.
    std::vector<common::Rgb> answers(w.queries.image_order.size(), common::Rgb(0, 0, 0));
    const common::Stopwatch gather;
    map.irradiance(w.queries.image_order, answers);
    m.gather_seconds = gather.seconds();
    const double sum = sum_of(answers);
    const common::Stopwatch gather_shuffled;
    map.irradiance(w.queries.shuffled, answers);
    m.gather_shuffled_seconds = gather_shuffled.seconds();
    const double shuffled_sum = sum_of(answers);
    m.mean_irradiance = (sum + shuffled_sum) / (6.0 * static_cast<double>(w.queries.image_order.size()));
    m.peak_resident_bytes = common::peak_resident_bytes();
}

void measure(const Contender& contender, Store& store, PreparedScene& scene, const Workload& w,
             Measurement& m) {
    const auto too_large = [&] {
        const std::size_t now = common::resident_bytes();
        return now > m.resident_before_bytes && now - m.resident_before_bytes > w.max_bytes;
    };
    m.trace = trace_into(store, run_of(w, [&](const common::TraceReport& so_far) {
                             if (too_large()) m.given_up = past_its_bound(w, so_far.hits);
                             return m.given_up.empty() && (!w.progress || w.progress(so_far));
                         }));
    if (m.trace.interrupted) return;
    const StoreFacts facts = store.facts();
    m.rejected = facts.rejected;
    m.insert_bytes = facts.bytes;

    const FinishedMap map = finish_with_direct(contender, store, m.trace, scene, w.seed);
    m.build_seconds = map.build_seconds;
    m.bytes = map.answers->bytes();
    if (too_large()) {
        m.given_up = past_its_bound(w, m.trace.hits);
        m.trace.interrupted = true;
        return;
    }
    measure_gather(*map.answers, w, m);
}

}  // namespace

Measurement measure_method(const Contender& contender, PreparedScene& scene, const Workload& workload) {
    Measurement m;
    m.preparation = contender->prepare(scene);
    m.peak_is_of_this_run = common::reset_peak_resident_bytes();
    m.resident_before_bytes = common::resident_bytes();
    try {
        const common::Stopwatch making_room;
        const std::unique_ptr<Store> store = contender->make_store(scene, workload.source);
        m.making_room_seconds = making_room.seconds();
        measure(contender, *store, scene, workload, m);
    } catch (const std::bad_alloc&) {
        m.given_up = "found no more memory";
        m.trace.interrupted = true;
    }
    return m;
}

common::TraceReport measure_null_sink(const Workload& workload) {
    return trace_into_nothing(run_of(workload, workload.progress));
}

}  // namespace bench::compare
