#include "bench/experiments/compare/compare_size.h"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "bench/contenders/memory_need.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"

namespace bench::compare {
namespace {

/// Makes the row of a method before any measurement, with the reason if it will not be run.
RowInput begin_row(const ComparePlan& plan, const CompareScene& scene, const Contender& method,
                   std::uint64_t hits) {
    RowInput row{.scene = scene.loaded.name,
                 .fingerprint = scene.fingerprint,
                 .method = method,
                 .hits_asked = hits,
                 .seed = plan.seed,
                 .threads = plan.threads,
                 .settings = plan.settings,
                 .queries = scene.queries.image_order.size(),
                 .texels = 0,
                 .null_sink = {},
                 .measurements = {},
                 .needed_bytes = needed_bytes(method, plan.settings, hits),
                 .max_bytes = plan.max_bytes,
                 .skipped = reason_to_skip(method, plan.settings, hits, plan.max_bytes)};
    if (!row.skipped.empty()) return row;
    try {
        row.texels = method->texel_count(scene.prepared);
    } catch (const common::InputError& e) {
        row.skipped = e.what();
    }
    return row;
}

/// Runs each method and the null sink once. Returns false if the user interrupted it.
bool run_once(const ComparePlan& plan, const CompareScene& scene, std::uint64_t hits, std::size_t repetition,
              std::vector<RowInput>& rows) {
    const auto workload = [&](common::Progress& progress) {
        return Workload{scene.loaded,
                        scene.source,
                        scene.queries,
                        plan.seed,
                        {.hits = hits},
                        [&progress](const common::TraceReport& so_far) {
                            progress.show(so_far.hits);
                            return !common::interrupted();
                        },
                        plan.max_bytes,
                        recorded_hits(plan.settings.direct)};
    };
    common::Progress null_progress(fmt::format("{} {} null sink", scene.loaded.name, hits), "hits", hits);
    const common::TraceReport null_sink = measure_null_sink(workload(null_progress));
    if (null_sink.interrupted) return false;

    std::vector<Measurement> measured(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t m = (i + repetition) % rows.size();
        if (!rows[m].skipped.empty()) continue;
        common::Progress progress(fmt::format("{} {} {}", scene.loaded.name, hits, rows[m].method.name),
                                  "hits", hits);
        measured[m] = measure_method(rows[m].method, scene.prepared, workload(progress));
        if (common::interrupted()) return false;
        rows[m].skipped = measured[m].given_up;  // of this and all further repetitions
    }
    for (std::size_t m = 0; m < rows.size(); ++m) {
        if (!rows[m].skipped.empty()) continue;
        rows[m].null_sink.push_back(null_sink);
        rows[m].measurements.push_back(measured[m]);
    }
    return true;
}

/// Traces briefly without measuring, since the first run of a process has cold caches, buffers and threads.
void warm_up(const ComparePlan& plan, const CompareScene& scene, std::uint64_t hits) {
    constexpr std::uint64_t enough = 300'000;
    (void)measure_null_sink(
        {scene.loaded, scene.source, scene.queries, plan.seed, {.hits = std::min(hits, enough)}, {}});
}

}  // namespace

SizeResult compare_size(const ComparePlan& plan, const CompareScene& scene,
                        const std::vector<Contender>& methods, std::uint64_t hits) {
    std::vector<RowInput> rows;
    for (const Contender& method : methods) rows.push_back(begin_row(plan, scene, method, hits));

    SizeResult result;
    const auto anything = [&] {
        return std::any_of(rows.begin(), rows.end(), [](const RowInput& r) { return r.skipped.empty(); });
    };
    if (anything()) warm_up(plan, scene, hits);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t done = 0; anything() && done < plan.repetitions && !result.interrupted; ++done) {
        const double elapsed =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double after_one_more =
            done == 0 ? 0 : elapsed * static_cast<double>(done + 1) / static_cast<double>(done);
        if (after_one_more > plan.seconds_per_size) break;
        result.interrupted = !run_once(plan, scene, hits, done, rows);
    }
    for (const RowInput& row : rows) {
        if (row.skipped.empty() && row.measurements.empty()) continue;
        result.rows.push_back(make_row(row));
        if (result.interrupted) result.rows.back()["interrupted"] = true;
    }
    return result;
}

}  // namespace bench::compare
