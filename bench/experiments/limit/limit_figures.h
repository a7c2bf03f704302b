// From the times of the parts to what the command says.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/experiments/limit/limit_parts.h"

namespace bench::limit {

/// Over the repetitions.
struct PairedRatio {
    double median, smallest, largest;
};

/// Seconds of `a` over seconds of `b`, each repetition's own, which has seen the same state of the machine.
/// An odd number of repetitions.
[[nodiscard]] PairedRatio paired_ratio(const std::vector<double>& a, const std::vector<double>& b);

/// What was run, NAME_ratio and NAME_ratio_range of every part's rays per second to those of single rays,
/// NAME_over_null of the times, rays_per_second, the seconds themselves and where they come from.
[[nodiscard]] nlohmann::ordered_json limit_as_json(const LimitSubject& subject, const LimitSeconds& seconds,
                                                   int threads);

/// For people.
[[nodiscard]] std::string limit_as_text(const LimitSubject& subject, const LimitSeconds& seconds,
                                        int threads);

}  // namespace bench::limit
