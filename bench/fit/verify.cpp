#include "bench/fit/verify.h"

#include <fmt/format.h>

#include "bench/fit/traced_run.h"
#include "bench/study/study_store.h"
#include "common/difference/error_metrics.h"
#include "common/difference/flip.h"

namespace bench::fit {
namespace {

VerifiedRun run_once(const Method& method, std::uint64_t hits, std::uint64_t seed, StudyScene& scene) {
    std::vector<StudyStore> stores;
    stores.emplace_back(MethodGroup{method}, scene.prepared(), scene.source());
    StudySink sink(stores);
    const auto trace = traced_run(fmt::format("{} seed {}", method.name, seed), scene.loaded(),
                                  scene.source(), seed, {.hits = hits}, sink);
    VerifiedRun run{.seed = seed, .hits = trace.hits};
    const double insert_seconds = stores.front().insert_seconds();
    stores.front().finish(trace, [&](const StudyMap& map) {
        const common::Stopwatch gather;
        const std::vector<common::Rgb> answers = ask(map, scene.points());
        run.seconds = trace.trace_seconds + insert_seconds + map.build_seconds + gather.seconds();
        run.bytes = map.bytes;
        const common::DifferenceFigures figures = common::difference(answers, scene.truth());
        run.error = figures.relative_rms;
        run.worst_share = figures.worst_share;
        run.flip = common::flip_mean(scene.flip(answers));
    });
    stop_if_interrupted();
    return run;
}

}  // namespace

std::vector<VerifiedRun> verify(const Candidate& candidate, std::uint64_t hits, std::uint64_t pilot_seed,
                                std::size_t seeds, StudyScene& scene) {
    const Method method = parse_method("fit", candidate.name(hits));
    std::vector<VerifiedRun> runs;
    for (std::size_t i = 1; i <= seeds; ++i) runs.push_back(run_once(method, hits, pilot_seed + i, scene));
    return runs;
}

}  // namespace bench::fit
