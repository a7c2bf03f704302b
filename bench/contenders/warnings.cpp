#include "bench/contenders/warnings.h"

#include <fmt/format.h>

#include <functional>

#include "common/core/standard_streams.h"
#include "common/gltf/warnings.h"
#include "common/tracer/rejected_hits.h"

namespace bench {
namespace {

using common::LightReach;

/// A fraction that is more than half beyond chance: half of the sky's light hits a lone floor from below.
constexpr double well_over_half = 0.55;

/// Adds one line for all lights that lose a fraction above `least` in one way, naming the worst.
void add_line(std::vector<std::string>& lines, const common::Pilot& pilot, double least,
              const std::function<double(const LightReach&)>& share, const char* what_happens) {
    const LightReach* worst = nullptr;
    std::size_t lights = 0;
    for (const LightReach& light : pilot.light) {
        if (share(light) <= least) continue;
        ++lights;
        if (!worst || share(light) > share(*worst)) worst = &light;
    }
    if (!worst) return;
    const std::string more = lights > 1 ? fmt::format(" (and most of the light of {} more)", lights - 1) : "";
    lines.push_back(fmt::format("{}: {:.3g} % of its light{} {}", common::gltf::one_line(worst->light),
                                100 * share(*worst), more, what_happens));
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void print_warning(const LoadedScene& scene, const std::string& text) {
    common::say(fmt::format("{}: warning: {}", scene.name, text));
}

std::vector<std::string> scene_warnings(const LoadedScene& scene) {
    std::vector<std::string> lines = scene.scene.warnings;
    const common::CoincidingTriangles& coinciding = scene.rays.coinciding_triangles();
    if (coinciding.covering > 0)
        lines.push_back(fmt::format(
            "{}{} triangles ({:.3g} m^2) lie over others in the same plane: where they do, the first in the "
            "file is met, but lamps before others and what lets light through after them",
            coinciding.all_compared ? "" : "at least ", coinciding.covering, coinciding.area));
    return lines;
}

void print_scene_warnings(const LoadedScene& scene) {
    for (const std::string& line : scene_warnings(scene)) print_warning(scene, line);
}

void print_light_warnings(const LoadedScene& scene, const common::PhotonSource& source) {
    for (const std::string& line : light_trouble(source)) print_warning(scene, line);
}

std::vector<std::string> light_trouble(const common::PhotonSource& source) {
    const common::Pilot& pilot = source.pilot();
    std::vector<std::string> lines;
    add_line(
        lines, pilot, 0.9, [](const LightReach& light) { return light.missed; },
        "meets no surface that could store it");
    add_line(
        lines, pilot, well_over_half, [](const LightReach& light) { return light.on_backs; },
        "falls on the backs of single-sided surfaces: light maps reject that, photon maps store it; normals "
        "may be reversed, or the light be on the wrong side");
    if (const std::string endless = endless_light(source); !endless.empty()) lines.push_back(endless);
    return lines;
}

std::string endless_light(const common::PhotonSource& source) {
    if (source.most_events() < common::max_events)
        return fmt::format(
            "light does not die out, as surfaces reflect all of it and none leaves: it is given up after {} "
            "surfaces, which decides how bright all is",
            source.most_events());
    if (source.pilot().endless > 0)
        return fmt::format("light hardly dies out: some {:.2g} % of it is given up after {} surfaces",
                           100 * source.pilot().endless, source.most_events());
    return "";
}

std::vector<std::string> run_trouble(const common::TraceReport& trace, const common::RejectedHits& rejected,
                                     const common::PhotonSource& source) {
    std::vector<std::string> lines;
    if (static_cast<double>(rejected.total()) > well_over_half * static_cast<double>(trace.hits)) {
        std::string reasons;
        const auto add = [&](std::uint64_t hits, const char* reason) {
            if (hits > 0)
                reasons += fmt::format("{}{:.3g} % {}", reasons.empty() ? "" : ", ",
                                       percent(hits, trace.hits), reason);
        };
        add(rejected.back_of_single_sided, "fell on the backs of single-sided surfaces");
        add(rejected.without_texel, "on surfaces without texels");
        add(rejected.outside_texels, "beside all texels");
        add(rejected.not_finite, "are not finite");
        lines.push_back(fmt::format("{:.3g} % of the hits are rejected: {}",
                                    percent(rejected.total(), trace.hits), reasons));
    }
    // If the pilot has met any, light_trouble says so already.
    if (source.pilot().endless == 0 && 100 * trace.fates.given_up > trace.fates.emitted)
        lines.push_back(fmt::format("{:.2g} % of the photons were given up after {} surfaces",
                                    percent(trace.fates.given_up, trace.fates.emitted),
                                    source.most_events()));
    return lines;
}

void print_lightmap_warnings(const LoadedScene& scene, const PreparedScene& prepared) {
    for (const std::string& line : prepared.lightmap_trouble()) print_warning(scene, line);
}

}  // namespace bench
