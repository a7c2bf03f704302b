// What decides which files of a light map's sums belong together.
#pragma once

#include "bench/app/methods.h"
#include "shlm/map_run.h"

namespace bench {

[[nodiscard]] shlm::MapIdentity map_identity(const ShlmMethod& method, PreparedMethods& prepared,
                                             const common::PhotonSource& source, std::uint64_t seed);

}  // namespace bench
