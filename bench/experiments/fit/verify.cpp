#include "bench/experiments/fit/verify.h"

#include <fmt/format.h>

#include "bench/contenders/trace_into.h"
#include "bench/experiments/fit/traced_run.h"
#include "common/core/stopwatch.h"
#include "common/difference/error_metrics.h"

namespace bench::fit {
namespace {

VerifiedRun run_once(const Contender& contender, std::uint64_t hits, std::uint64_t seed,
                     ReferenceScene& scene, const StopRule& stop) {
    FilledStore filled({contender}, scene.prepared(), scene.source());
    const auto trace = traced_run(fmt::format("{} seed {}", contender.name, seed), scene.loaded(),
                                  scene.source(), seed, {.hits = hits}, std::span(&filled, 1), stop);
    const FinishedMap map = contender->finish(*filled.store, trace);
    const common::Stopwatch gather;
    const std::vector<common::Rgb> answers = ask(*map.answers, scene.points());
    VerifiedRun run{.seed = seed, .hits = trace.hits};
    run.seconds = trace.trace_seconds + filled.seconds() + map.build_seconds + gather.seconds();
    run.bytes = map.answers->bytes();
    const common::DifferenceFigures figures = common::difference(answers, scene.truth());
    run.error = figures.relative_rms;
    run.worst_share = figures.worst_share;
    stop.check();
    return run;
}

}  // namespace

std::vector<VerifiedRun> verify(const Candidate& candidate, std::uint64_t hits, std::uint64_t pilot_seed,
                                std::size_t seeds, ReferenceScene& scene) {
    const Contender contender = candidate.contender(hits);
    std::vector<VerifiedRun> runs;
    try {
        for (std::size_t i = 1; i <= seeds; ++i)
            runs.push_back(run_once(contender, hits, pilot_seed + i, scene, StopRule()));
    } catch (const Stopped&) {  // by the user: the finished runs are kept
    }
    return runs;
}

}  // namespace bench::fit
