// A run of a fit's own: shows how far it is, and ends where the user ends it.
#pragma once

#include <string>

#include "bench/contenders/trace_into.h"

namespace bench::fit {

/// Throws Interrupted.
[[nodiscard]] common::TraceReport traced_run(const std::string& title, const LoadedScene& scene,
                                             const common::PhotonSource& source, std::uint64_t seed,
                                             const common::TraceTarget& target,
                                             std::span<FilledStore> stores);

}  // namespace bench::fit
