// What a user should know of a scene before its results are looked at, a line each on stderr.
#pragma once

#include <string>
#include <vector>

#include "bench/contenders/contender.h"
#include "common/tracer/rejected_hits.h"
#include "common/tracer/trace_report.h"

namespace bench {

void print_warning(const LoadedScene& scene, const std::string& text);

/// What its file asks for and does not get, and where it leaves open what is there.
[[nodiscard]] std::vector<std::string> scene_warnings(const LoadedScene& scene);
void print_scene_warnings(const LoadedScene& scene);

/// What becomes of its light: light_trouble.
void print_light_warnings(const LoadedScene& scene, const common::PhotonSource& source);

/// Lights most of whose light no surface gets, or the backs of surfaces only, and light that does not end: by
/// the source's pilot.
[[nodiscard]] std::vector<std::string> light_trouble(const common::PhotonSource& source);

/// That light does not end; empty where it does.
[[nodiscard]] std::string endless_light(const common::PhotonSource& source);

/// Hits that found no place in the map, where most did not, and photons that were given up.
[[nodiscard]] std::vector<std::string> run_trouble(const common::TraceReport& trace,
                                                   const common::RejectedHits& rejected,
                                                   const common::PhotonSource& source);

/// What stands in the way of light maps.
void print_lightmap_warnings(const LoadedScene& scene, const PreparedScene& prepared);

}  // namespace bench
