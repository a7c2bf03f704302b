// A run that belongs to a fit: it shows its progress and obeys the stop rule.
#pragma once

#include <string>

#include "bench/contenders/trace_into.h"
#include "bench/experiments/fit/stop.h"

namespace bench::fit {

/// Traces `target` into `stores`. Throws Stopped.
[[nodiscard]] common::TraceReport traced_run(const std::string& title, const LoadedScene& scene,
                                             const common::PhotonSource& source, std::uint64_t seed,
                                             const common::TraceTarget& target, std::span<FilledStore> stores,
                                             const StopRule& stop);

}  // namespace bench::fit
