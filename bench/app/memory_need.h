// What a run will need, before it is started.
#pragma once

#include <cstddef>
#include <string>

#include "bench/app/methods.h"

namespace bench {

/// An upper bound for the bytes that a method holds at its peak, map and index together; the scene is not in
/// it. Photon maps: per hit, measured and rounded up. SHLM: per texel, whatever the hits.
[[nodiscard]] std::size_t needed_bytes(const Method& method, const MethodSettings& settings,
                                       std::uint64_t hits);

/// Why a run of this size cannot be had within `max_bytes`: "needs 67.1 GiB"; empty where it can.
[[nodiscard]] std::string reason_to_skip(const Method& method, const MethodSettings& settings,
                                         std::uint64_t hits, std::size_t max_bytes);

/// Throws InputError where a run of this size cannot be had: "METHOD: needs 67.1 GiB, 19.8 GiB are free for
/// it".
void require_memory(const Method& method, const MethodSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes);

/// Nine tenths of the memory that is free now: the rest is for the scene and for everybody else.
[[nodiscard]] std::size_t default_max_bytes();

}  // namespace bench
