// The timed parts: the same rays through Embree alone, and traced into three sinks.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/contenders/contender.h"
#include "bench/experiments/limit/recorded_run.h"

namespace bench::limit {

enum class LimitPart : std::size_t { single, sorted_single, packet, sorted_packet, null, shlm, photonmap };

/// Names of the parts in the table and in the JSON.
inline constexpr std::array<std::string_view, 7> limit_part_names = {
    "single", "sorted_single", "packet", "sorted_packet", "null", "shlm", "photonmap"};

/// A recorded run, ready to be traced again.
struct LimitSubject {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    PreparedScene& prepared;
    Contender light_map, photon_map;
    std::uint64_t seed;
    RecordedRun run;
    std::vector<RayBlock> sorted;  ///< run.blocks in PhotonOrder
};

/// Wall seconds of each repetition, by LimitPart.
using LimitSeconds = std::array<std::vector<double>, limit_part_names.size()>;

/// Checks that packets find what single rays find, and that tracing the same photons reproduces the recorded
/// hits and fates. Throws std::runtime_error otherwise. It also warms up what is timed next.
void check_answers(const LimitSubject& subject);

/// Times every part in every repetition; each repetition begins with another part. Calls `progress` after
/// each part with the number of parts done, and ends if it returns false. Making and finishing the sinks is
/// not timed. Uses the threads of the calling arena.
[[nodiscard]] LimitSeconds measure_limit(const LimitSubject& subject, std::size_t repetitions,
                                         const std::function<bool(std::size_t parts_done)>& progress);

}  // namespace bench::limit
