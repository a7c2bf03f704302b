// Computes the command's figures from the times of the parts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/experiments/limit/limit_parts.h"

namespace bench::limit {

/// A ratio over the repetitions.
struct PairedRatio {
    double median, smallest, largest;
};

/// Returns the seconds of `a` over the seconds of `b`. Ratios are taken within each repetition, which sees
/// one state of the machine. The number of repetitions must be odd.
[[nodiscard]] PairedRatio paired_ratio(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the subject; for every part, NAME_ratio and NAME_ratio_range of its rays per second over those of
/// single rays; NAME_over_null of the times; rays_per_second; the seconds themselves, and their provenance.
[[nodiscard]] nlohmann::ordered_json limit_as_json(const LimitSubject& subject, const LimitSeconds& seconds,
                                                   int threads);

/// Formats the figures for a terminal.
[[nodiscard]] std::string limit_as_text(const LimitSubject& subject, const LimitSeconds& seconds,
                                        int threads);

}  // namespace bench::limit
