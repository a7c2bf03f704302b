// What a run will need, before it is started.
#pragma once

#include <cstddef>
#include <string>

#include "bench/contenders/contender.h"

namespace bench {

/// An upper bound for the bytes that a contender holds at its peak, hits on their way to it included; the
/// scene is not in it.
[[nodiscard]] std::size_t needed_bytes(const Contender& contender, const ContenderSettings& settings,
                                       std::uint64_t hits);

/// Why a run of this size cannot be had within `max_bytes`: "needs 67.1 GiB"; empty where it can.
[[nodiscard]] std::string reason_to_skip(const Contender& contender, const ContenderSettings& settings,
                                         std::uint64_t hits, std::size_t max_bytes);

/// Throws InputError where a run of this size cannot be had: "NAME: needs 67.1 GiB, 19.8 GiB are free for
/// it".
void require_memory(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes);

/// Nine tenths of what the machine has free.
[[nodiscard]] std::size_t default_max_bytes();

}  // namespace bench
