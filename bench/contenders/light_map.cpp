#include "bench/contenders/light_map.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/contenders/family.h"
#include "bench/contenders/light_map_names.h"
#include "bench/setup/register_once.h"
#include "common/core/stopwatch.h"
#include "common/scene/fingerprint.h"

namespace bench {
namespace {

constexpr std::size_t most_hits = 1'000'000;
constexpr double index_bytes = 46;  // of FLANN's tree over the texels: 33 to 42 by leaf fill

std::map<int, LightBasis>& bases() {
    static std::map<int, LightBasis> all;
    return all;
}

std::vector<std::string> basis_names() {
    std::vector<std::string> names;
    for (const auto& [place, basis] : bases()) names.push_back(basis.name);
    return names;
}

constexpr std::size_t most_neighbours = 100'000;
const std::string gather_form =
    fmt::format("own, bilinear, surfaceK or knnK with K from 1 to {}", most_neighbours);
const std::string rest_form =
    "uv, face, a number of texels such as t65536, of hits to a block such as h0, or half, in this order";

shlm::Gather take_gather(NameParts& parts) {
    const std::string part = parts.take("surface4");
    if (part == "own") return shlm::OwnTexel{};
    if (part == "bilinear") return shlm::Bilinear{};
    for (const auto& [prefix, of_own_surface] : {std::pair("surface", true), std::pair("knn", false)})
        if (const auto count = count_after(prefix, part, 1, most_neighbours))
            return shlm::NearestTexels{*count, of_own_surface};
    parts.complain(part, gather_form);
}

shlm::ShWeight take_weight(NameParts& parts, const LightBasis& basis) {
    if (parts.at_end()) return basis.weights.front();
    const std::vector<std::string> all = {"radiance", "flux", "normalised"};
    const std::string name = all[parts.take_one_of(all)];
    for (const shlm::ShWeight weight : basis.weights)
        if (name == name_of(weight)) return weight;
    parts.complain(
        name, fmt::format("{}, the only weight that {} has", name_of(basis.weights.front()), basis.name));
}

std::shared_ptr<const Technique> parse(NameParts& parts) {
    for (const LightMapKind& kind : light_map_kinds())
        if (auto technique = kind.parse(parts)) return technique;
    TexelSetting setting;
    setting.basis = &basis_named(basis_names()[parts.take_one_of(basis_names())]);
    setting.weight = take_weight(parts, *setting.basis);
    setting.gather = take_gather(parts);
    take_texels(parts, setting);
    std::uint64_t least_hits = shlm::default_least_hits;
    if (const auto hits = count_after("h", parts.peek(), 0, most_hits)) {
        least_hits = *hits;
        (void)parts.take("");
    }
    const bool in_halves = parts.peek() == "half";
    if (in_halves) (void)parts.take("");
    if (!parts.at_end()) parts.complain(parts.peek(), rest_form);
    return std::make_shared<UniformLightMap>(setting, least_hits, in_halves);
}

std::vector<NameField> fields() {
    std::string kinds;
    for (const LightMapKind& kind : light_map_kinds()) kinds += ", or " + kind.form;
    return {
        {"basis", one_of(basis_names()) + kinds, "what a finished texel keeps of its light"},
        {"weight", one_of({"radiance", "flux", "normalised"}),
         "what a hit stands for: radiance is right; flux is the paper read literally; normalised is exact "
         "at the surface's own normal"},
        {"gather", gather_form,
         "which texels answer: the point's own, the four around it, the nearest K of its own surface, or "
         "the nearest K in space, as in the paper"},
        {"rest", rest_form,
         "each may be left out: texels by lightmap coordinates or by faces; their number; hits below which "
         "texels share a light; numbers in half floats"}};
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const std::string& basis : basis_names()) all.push_back("shlm/" + basis);
    for (const LightMapKind& kind : light_map_kinds()) all.push_back(kind.example);
    return all;
}

const RegisteredFamily registered("shlm", {"light maps of texels that sum hits in harmonics (Good and Taylor "
                                           "2005)",
                                           parse, fields, names});

}  // namespace

const std::map<int, LightBasis>& light_bases() {
    return bases();
}

RegisteredBasis::RegisteredBasis(int place, const LightBasis& basis) {
    register_once(bases(), place, basis);
}

const char* name_of(shlm::ShWeight weight) {
    switch (weight) {
        case shlm::ShWeight::flux:
            return "flux";
        case shlm::ShWeight::normalised:
            return "normalised";
        case shlm::ShWeight::radiance:
            break;
    }
    return "radiance";
}

TexelChoice LightMapTechnique::texel_choice(const ContenderSettings& settings) const {
    return {setting_.texels > 0 ? setting_.texels : settings.texels.count,
            setting_.placement.value_or(settings.texels.placement)};
}

std::string LightMapTechnique::store_key() const {
    return fmt::format("shlm/L{}/{}/{}/{}", setting_.basis->order, bench::name_of(setting_.weight),
                       setting_.placement ? bench::name_of(*setting_.placement) : "", setting_.texels);
}

shlm::MapIdentity LightMapTechnique::identity(PreparedScene& scene, const common::PhotonSource& source,
                                              std::uint64_t seed) const {
    return {.scene = common::fingerprint(scene.scene()),
            .model = fmt::format("L{}/{}", setting_.basis->order, bench::name_of(setting_.weight)),
            .texels_wanted = describe(texel_choice(scene.settings())),
            .texels = texels_of(scene).layout.texel_count(),
            .numbers = setting_.basis->numbers(setting_.weight),
            .quantum = shlm::Quantum(source.power()).exponents(),
            .seed = seed};
}

std::unique_ptr<LightMapStore> LightMapTechnique::make_sums(PreparedScene& scene,
                                                            const common::PhotonSource& source) const {
    return setting_.basis->make_store(setting_.weight, texels_of(scene), shlm::Quantum(source.power()));
}

std::string LightMapTechnique::texel_name() const {
    std::string name = bench::name_of(setting_.gather);
    if (setting_.placement) name += fmt::format("/{}", bench::name_of(*setting_.placement));
    if (setting_.texels > 0) name += fmt::format("/t{}", setting_.texels);
    return name;
}

nlohmann::ordered_json LightMapTechnique::texel_fields() const {
    nlohmann::ordered_json fields = {{"weight", bench::name_of(setting_.weight)},
                                     {"gather", bench::name_of(setting_.gather)}};
    if (setting_.placement) fields["placement"] = bench::name_of(*setting_.placement);
    if (setting_.texels > 0) fields["texels"] = setting_.texels;
    fields["summed_order"] = setting_.basis->order;
    return fields;
}

std::string UniformLightMap::name() const {
    std::string name =
        fmt::format("shlm/{}/{}/{}", setting().basis->name, bench::name_of(setting().weight), texel_name());
    if (least_hits_ != shlm::default_least_hits) name += fmt::format("/h{}", least_hits_);
    if (in_halves_) name += "/half";
    return name;
}

nlohmann::ordered_json UniformLightMap::fields() const {
    nlohmann::ordered_json fields = {{"family", "shlm"}, {"basis", setting().basis->name}};
    fields.update(texel_fields());
    fields["least_hits"] = least_hits_;
    fields["half"] = in_halves_;
    return fields;
}

/// Counts the sums, a finished map and its index, which exist together. Half floats are made from floats.
double UniformLightMap::needed_bytes(const ContenderSettings& settings, std::uint64_t) const {
    const LightBasis& basis = *setting().basis;
    const double finished = (in_halves_ ? 2.0 : 1.0) * static_cast<double>(basis.texel_bytes);
    const double filled =
        static_cast<double>(basis.sum_bytes(setting().weight)) + sizeof(shlm::TexelGeometry);
    const double lookup = 2 * sizeof(common::Vec3) + sizeof(std::uint32_t) + index_bytes;
    return static_cast<double>(texel_choice(settings).count) * (filled + finished + lookup);
}

FinishedMap UniformLightMap::finish(Store& store, const common::TraceReport& trace) const {
    const common::Stopwatch build;
    auto answers =
        setting().basis->finish(static_cast<const LightMapStore&>(store), setting().weight,
                                trace.watts_per_flux(), {setting().gather, least_hits_, in_halves_});
    return {std::move(answers), build.seconds()};
}

}  // namespace bench
