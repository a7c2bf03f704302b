// Predicts the memory that a run will need.
#pragma once

#include <cstddef>
#include <string>

#include "bench/contenders/contender.h"

namespace bench {

/// Returns an upper bound for the bytes that a contender holds at its peak, with the hits on their way to it
/// but without the scene.
[[nodiscard]] std::size_t needed_bytes(const Contender& contender, const ContenderSettings& settings,
                                       std::uint64_t hits);

/// Returns why a run of this size is impossible within `max_bytes`, as in "needs 67.1 GiB"; empty where it is
/// possible.
[[nodiscard]] std::string reason_to_skip(const Contender& contender, const ContenderSettings& settings,
                                         std::uint64_t hits, std::size_t max_bytes);

/// Throws InputError where a run of this size is impossible: "NAME: needs 67.1 GiB, 19.8 GiB are free for
/// it".
void require_memory(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes);

/// Returns nine tenths of the free memory of the machine.
[[nodiscard]] std::size_t default_max_bytes();

}  // namespace bench
