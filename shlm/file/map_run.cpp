#include "shlm/file/map_run.h"

#include <fmt/format.h>

#include <charconv>

#include "common/core/input_error.h"

namespace shlm {
namespace {

constexpr const char* format_version = "1";

/// The count of photons that were not sent, as their light emits nothing there; left out if it is 0.
constexpr const char* photons_without_light = "photons_without_light";

/// Calls `visit(name, number)` for all of the run's numbers except that count.
template <class Run, class Visit>
void for_each_number(Run& run, Visit visit) {
    visit("seed", run.identity.seed);
    visit("texels", run.identity.texels);
    visit("numbers", run.identity.numbers);
    visit("quantum_exponent_red", run.identity.quantum[0]);
    visit("quantum_exponent_green", run.identity.quantum[1]);
    visit("quantum_exponent_blue", run.identity.quantum[2]);
    visit("first_photon", run.first_photon);
    visit("photons", run.fates.emitted);
    visit("photons_missed", run.fates.missed);
    visit("photons_escaped", run.fates.escaped);
    visit("photons_absorbed", run.fates.absorbed);
    visit("photons_given_up", run.fates.given_up);
    visit("hits", run.hits);
    visit("hits_not_finite", run.rejected.not_finite);
    visit("hits_without_lightmap_uv", run.rejected.without_texel);
    visit("hits_on_back_of_single_sided", run.rejected.back_of_single_sided);
    visit("clamped_light_flux", run.clamped.flux);
    visit("clamped_light_discarded", run.clamped.discarded);
}

std::string key_of(const std::string& name) {
    return "shlmbench:" + name;
}

const std::string& note(const std::map<std::string, std::string>& notes, const std::string& name) {
    const auto found = notes.find(key_of(name));
    if (found == notes.end()) throw common::InputError("it is not a light map's checkpoint: no " + name);
    return found->second;
}

template <class Number>
void parse(const std::string& name, const std::string& text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        throw common::InputError(fmt::format("its header is broken: {} is '{}'", name, text));
}

}  // namespace

std::string MapIdentity::difference(const MapIdentity& found) const {
    const auto say = [](const char* what, const auto& has, const auto& wanted) {
        return fmt::format("it has {} {}, not {}", what, has, wanted);
    };
    if (found.scene != scene) return say("the scene with fingerprint", found.scene, scene);
    if (found.model != model) return say("a map of kind", found.model, model);
    if (found.texels_wanted != texels_wanted) return say("texels", found.texels_wanted, texels_wanted);
    if (found.texels != texels) return say("texels in all:", found.texels, texels);
    if (found.numbers != numbers) return say("numbers per texel:", found.numbers, numbers);
    if (found.quantum != quantum) return "it counts light in other units";
    if (found.seed != seed) return say("seed", found.seed, seed);
    return "";
}

common::TraceReport MapRun::report() const {
    common::TraceReport report;
    report.fates = fates;
    report.hits = hits;
    return report;
}

void MapRun::append(const MapRun& next) {
    fates += next.fates;
    hits += next.hits;
    rejected += next.rejected;
    clamped += next.clamped;
}

std::map<std::string, std::string> to_notes(const MapRun& run) {
    std::map<std::string, std::string> notes = {{key_of("map_format"), format_version},
                                                {key_of("scene_fingerprint"), run.identity.scene},
                                                {key_of("model"), run.identity.model},
                                                {key_of("texels_wanted"), run.identity.texels_wanted},
                                                {key_of("commit"), run.program}};
    for_each_number(
        run, [&](const char* name, const auto& number) { notes[key_of(name)] = std::to_string(number); });
    if (run.fates.without_light > 0)
        notes[key_of(photons_without_light)] = std::to_string(run.fates.without_light);
    return notes;
}

MapRun map_run_of(const std::map<std::string, std::string>& notes) {
    if (const std::string version = note(notes, "map_format"); version != format_version)
        throw common::InputError(
            fmt::format("its format is {}, this program reads {}", version, format_version));
    MapRun run;
    run.identity.scene = note(notes, "scene_fingerprint");
    run.identity.model = note(notes, "model");
    run.identity.texels_wanted = note(notes, "texels_wanted");
    run.program = note(notes, "commit");
    for_each_number(run, [&](const char* name, auto& number) { parse(name, note(notes, name), number); });
    if (notes.contains(key_of(photons_without_light)))
        parse(photons_without_light, note(notes, photons_without_light), run.fates.without_light);
    return run;
}

}  // namespace shlm
