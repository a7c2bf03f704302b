#include "bench/experiments/limit/limit_parts.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/contenders/trace_into.h"
#include "bench/experiments/limit/replay.h"
#include "common/core/interrupt.h"
#include "common/core/stopwatch.h"

namespace bench::limit {
namespace {

/// Returns the run that traces the recorded photons again.
TracedRun run_of(const LimitSubject& subject) {
    return {subject.loaded.rays,
            subject.source,
            subject.seed,
            {.photons = subject.run.report.fates.emitted},
            [](const common::TraceReport&) { return !common::interrupted(); }};
}

template <class Work>
double seconds_of(const Work& work) {
    const common::Stopwatch watch;
    work();
    return watch.seconds();
}

double trace_seconds(const Contender& contender, const LimitSubject& subject) {
    const std::unique_ptr<Store> store = contender->make_store(subject.prepared, subject.source);
    return seconds_of([&] { (void)trace_into(*store, run_of(subject)); });
}

double measure(LimitPart part, const LimitSubject& subject) {
    const common::RayScene& rays = subject.loaded.rays;
    switch (part) {
        case LimitPart::single:
            return seconds_of([&] { replay_single(rays, subject.run.blocks); });
        case LimitPart::sorted_single:
            return seconds_of([&] { replay_single(rays, subject.sorted); });
        case LimitPart::packet:
            return seconds_of([&] { replay_packets(rays, subject.run.blocks); });
        case LimitPart::sorted_packet:
            return seconds_of([&] { replay_packets(rays, subject.sorted); });
        case LimitPart::shlm:
            return trace_seconds(subject.light_map, subject);
        case LimitPart::photonmap:
            return trace_seconds(subject.photon_map, subject);
        case LimitPart::null:
            break;
    }
    return seconds_of([&] { (void)trace_into_nothing(run_of(subject)); });
}

bool same_run(const common::TraceReport& a, const common::TraceReport& b) {
    return a.hits == b.hits && a.fates.missed == b.fates.missed && a.fates.escaped == b.fates.escaped &&
           a.fates.absorbed == b.fates.absorbed && a.fates.given_up == b.fates.given_up &&
           a.fates.without_light == b.fates.without_light;
}

}  // namespace

void check_answers(const LimitSubject& subject) {
    for (const auto* blocks : {&subject.run.blocks, &subject.sorted})
        if (const auto differences = count_differences(subject.loaded.rays, *blocks))
            throw std::runtime_error(
                fmt::format("limit: {} of {} rays find another surface in packets than alone", differences,
                            subject.run.rays));
    const common::TraceReport traced = trace_into_nothing(run_of(subject));
    if (!traced.interrupted && !same_run(traced, subject.run.report))
        throw std::runtime_error(fmt::format("limit: tracing makes {} hits of {} photons, one by one {}",
                                             traced.hits, traced.fates.emitted, subject.run.report.hits));
}

LimitSeconds measure_limit(const LimitSubject& subject, std::size_t repetitions,
                           const std::function<bool(std::size_t)>& progress) {
    LimitSeconds seconds;
    std::size_t done = 0;
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition)
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            const std::size_t part = (i + repetition) % seconds.size();
            seconds[part].push_back(measure(static_cast<LimitPart>(part), subject));
            if (!progress(++done)) return seconds;
        }
    return seconds;
}

}  // namespace bench::limit
