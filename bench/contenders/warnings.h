// Warnings about a scene that users should read before its results, one line each on stderr.
#pragma once

#include <string>
#include <vector>

#include "bench/contenders/contender.h"
#include "common/tracer/rejected_hits.h"
#include "common/tracer/trace_report.h"

namespace bench {

void print_warning(const LoadedScene& scene, const std::string& text);

/// Returns what the scene's file asks for without getting it, and where its surfaces are ambiguous.
[[nodiscard]] std::vector<std::string> scene_warnings(const LoadedScene& scene);
void print_scene_warnings(const LoadedScene& scene);

/// Prints the warnings about its lights: light_trouble.
void print_light_warnings(const LoadedScene& scene, const common::PhotonSource& source);

/// Reports, from the source's pilot, lights most of whose light reaches no surface or only backs of surfaces,
/// and light that does not die out.
[[nodiscard]] std::vector<std::string> light_trouble(const common::PhotonSource& source);

/// Reports that light does not die out; empty where it does.
[[nodiscard]] std::string endless_light(const common::PhotonSource& source);

/// Reports hits that found no place in the map, if most did not, and photons that were terminated.
[[nodiscard]] std::vector<std::string> run_trouble(const common::TraceReport& trace,
                                                   const common::RejectedHits& rejected,
                                                   const common::PhotonSource& source);

/// Prints the problems of the scene's lightmap coordinates.
void print_lightmap_warnings(const LoadedScene& scene, const PreparedScene& prepared);

}  // namespace bench
