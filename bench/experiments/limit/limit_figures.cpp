#include "bench/experiments/limit/limit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "bench/setup/median.h"
#include "bench/setup/provenance.h"
#include "common/scene/fingerprint.h"

namespace bench::limit {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<double>& of(LimitPart part, const LimitSeconds& seconds) {
    return seconds[static_cast<std::size_t>(part)];
}

/// Returns the rate of a part over that of single rays. All parts have the same rays, so this is the inverse
/// ratio of the times.
PairedRatio rate_to_single(std::size_t part, const LimitSeconds& seconds) {
    return paired_ratio(of(LimitPart::single, seconds), seconds[part]);
}

double rays_per_second(const LimitSubject& subject, const std::vector<double>& seconds) {
    return static_cast<double>(subject.run.rays) / median(seconds);
}

void add(Json& all, const std::string& name, const PairedRatio& ratio) {
    all[name] = ratio.median;
    all[name + "_range"] = {ratio.smallest, ratio.largest};
}

/// Formats as 0.93 (0.91 to 0.95).
std::string text_of(const PairedRatio& ratio) {
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", ratio.median, ratio.smallest, ratio.largest);
}

std::string description(std::size_t part, const LimitSubject& subject) {
    switch (static_cast<LimitPart>(part)) {
        case LimitPart::single:
            return "Embree alone, single rays";
        case LimitPart::sorted_single:
            return "Embree alone, single sorted rays";
        case LimitPart::packet:
            return "Embree alone, packets";
        case LimitPart::sorted_packet:
            return "Embree alone, packets of sorted rays";
        case LimitPart::shlm:
            return "tracing into " + subject.light_map.name;
        case LimitPart::photonmap:
            return "tracing into " + subject.photon_map.name;
        case LimitPart::null:
            break;
    }
    return "tracing into the null sink";
}

}  // namespace

PairedRatio paired_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios(a.size());
    std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), std::divides<>());
    const auto [smallest, largest] = std::minmax_element(ratios.begin(), ratios.end());
    return {median(ratios), *smallest, *largest};
}

Json limit_as_json(const LimitSubject& subject, const LimitSeconds& seconds, int threads) {
    Json all = {{"scene", subject.loaded.name},
                {"scene_fingerprint", common::fingerprint(subject.loaded.scene)},
                {"light_map", subject.light_map.name},
                {"texels", subject.light_map->texel_count(subject.prepared)},
                {"photon_map", subject.photon_map.name},
                {"seed", subject.seed},
                {"threads", threads},
                {"repetitions", seconds[0].size()},
                {"hits", subject.run.report.hits},
                {"photons", subject.run.report.fates.emitted},
                {"rays", subject.run.rays},
                {"differing_rays", 0}};  // guaranteed by check_answers
    for (std::size_t part = 1; part < seconds.size(); ++part)
        add(all, fmt::format("{}_ratio", limit_part_names[part]), rate_to_single(part, seconds));
    for (const LimitPart part : {LimitPart::shlm, LimitPart::photonmap})
        add(all, fmt::format("{}_over_null", limit_part_names[static_cast<std::size_t>(part)]),
            paired_ratio(of(part, seconds), of(LimitPart::null, seconds)));
    for (std::size_t part = 0; part < seconds.size(); ++part) {
        const std::string name(limit_part_names[part]);
        all["rays_per_second"][name] = rays_per_second(subject, seconds[part]);
        all["seconds"][name] = seconds[part];
    }
    all["context"] = provenance();
    return all;
}

std::string limit_as_text(const LimitSubject& subject, const LimitSeconds& seconds, int threads) {
    std::string text = fmt::format(
        "{}: {} hits and {} rays of {} photons, seed {}, {} threads, {} repetitions\n\n"
        "{:<40} {:>9}  rate / single rays, median and range\n",
        subject.loaded.name, subject.run.report.hits, subject.run.rays, subject.run.report.fates.emitted,
        subject.seed, threads, seconds[0].size(), "", "M rays/s");
    for (std::size_t part = 0; part < seconds.size(); ++part)
        text += fmt::format("{:<40} {:>9.2f}  {}\n", description(part, subject),
                            rays_per_second(subject, seconds[part]) / 1e6,
                            part == 0 ? "1" : text_of(rate_to_single(part, seconds)));
    text += fmt::format("\n{:<40} {:>9}  time / null sink, median and range\n", "", "");
    for (const LimitPart part : {LimitPart::shlm, LimitPart::photonmap})
        text += fmt::format("{:<40} {:>9}  {}\n", description(static_cast<std::size_t>(part), subject), "",
                            text_of(paired_ratio(of(part, seconds), of(LimitPart::null, seconds))));
    return text;
}

}  // namespace bench::limit
