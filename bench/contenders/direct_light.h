// Direct light apart: photons bring indirect light alone, and direct light is sampled at each question.
#pragma once

#include "bench/contenders/contender.h"
#include "bench/setup/command.h"
#include "common/reference/lights.h"
#include "common/tracer/trace_block.h"

namespace bench {

/// The option for it, of commands that trace and ask at once.
struct DirectOptions {
    std::string direct = "photons";
    int samples = 64;

    void add_to(Command& command);

    /// Throws InputError for values without a meaning.
    [[nodiscard]] DirectSetting setting() const;
};

/// Returns which hits the stores of a run take.
[[nodiscard]] common::RecordedHits recorded_hits(const DirectSetting& direct);

/// Adds where direct light comes from, and how photons are spread, to a row of results: what is not the
/// default.
void add_run_facts(nlohmann::ordered_json& row, const ContenderSettings& settings);

/// Makes the map of a whole run, as Technique::finish. Where direct light is sampled, the answers add it:
/// the mean of DirectSetting::samples estimates by common::reference::sample_irradiance. They depend on the
/// run's seed and the point alone. `scene` must outlive the map.
[[nodiscard]] FinishedMap finish_with_direct(const Contender& contender, Store& store,
                                             const common::TraceReport& trace, PreparedScene& scene,
                                             std::uint64_t seed);

}  // namespace bench
