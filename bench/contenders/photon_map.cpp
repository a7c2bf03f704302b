#include "bench/contenders/photon_map.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/contenders/family.h"
#include "bench/setup/register_once.h"

namespace bench {
namespace {

constexpr std::size_t most_neighbours = 100'000;

std::map<int, PhotonMapEngine>& engines() {
    static std::map<int, PhotonMapEngine> all;
    return all;
}

const std::vector<std::string> kernel_names = {"disc", "cone", "epanechnikov"};  // in the order of Kernel

std::vector<std::string> engine_names() {
    std::vector<std::string> names;
    for (const auto& [place, engine] : engines()) names.push_back(engine.name);
    return names;
}

const std::string radius_form = "rF of F scene diagonals, from 1e-6 to 1";
const std::string selection_form = fmt::format(
    "kK with K from 2 to {} (one photon has no density), kCn23 for k = C N^(2/3), or rF for a "
    "radius of F scene diagonals, from 1e-6 to 1",
    most_neighbours);

std::optional<photonmap::FixedRadius> fixed_radius(const std::string& part) {
    const auto fraction = number_between("r", part, "");
    if (!fraction || *fraction < 1e-6 || *fraction > 1) return std::nullopt;
    return photonmap::FixedRadius{*fraction};
}

/// Parses a radius, the only selection of an index that is made for one radius: it knows no k nearest.
photonmap::PhotonSelection take_radius(NameParts& parts, const std::string& engine) {
    const std::string part = parts.take("r0.003");
    if (const auto radius = fixed_radius(part)) return *radius;
    parts.complain(part, fmt::format("a radius {}: a {} knows no other selection", radius_form, engine));
}

photonmap::PhotonSelection take_selection(NameParts& parts) {
    const std::string part = parts.take("k50");
    if (const auto count = count_after("k", part, 2, most_neighbours))
        return photonmap::NearestPhotons{*count};
    if (const auto factor = number_between("k", part, "n23"); factor && *factor > 0 && *factor <= 1)
        return photonmap::GrowingNumber{*factor};
    if (const auto radius = fixed_radius(part)) return *radius;
    parts.complain(part, selection_form);
}

std::string name_of(const photonmap::PhotonSelection& selection) {
    if (const auto* nearest = std::get_if<photonmap::NearestPhotons>(&selection))
        return fmt::format("k{}", nearest->count);
    if (const auto* growing = std::get_if<photonmap::GrowingNumber>(&selection))
        return fmt::format("k{}n23", growing->factor);
    return fmt::format("r{}", std::get<photonmap::FixedRadius>(selection).diagonal_fraction);
}

std::shared_ptr<const Technique> parse(NameParts& parts) {
    const std::size_t place = parts.take_one_of(engine_names());
    const PhotonMapEngine& engine = std::next(engines().begin(), static_cast<std::ptrdiff_t>(place))->second;
    const photonmap::PhotonSelection selection =
        engine.for_one_radius ? take_radius(parts, engine.name) : take_selection(parts);
    const auto kernel = static_cast<photonmap::Kernel>(parts.take_one_of(kernel_names));
    return std::make_shared<PhotonMapTechnique>(engine, selection, kernel);
}

std::vector<NameField> fields() {
    return {{"engine", one_of(engine_names()), "what photons are kept in and found with"},
            {"selection", selection_form, "which photons are gathered; k50 where nothing is said"},
            {"kernel", one_of(kernel_names), "how a photon's weight falls off with its distance"}};
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const std::string& engine : engine_names()) all.push_back("photonmap/" + engine);
    return all;
}

const RegisteredFamily registered("photonmap", {"photons on surfaces, gathered around a point (Jensen 2001)",
                                                parse, fields, names});

}  // namespace

RegisteredEngine::RegisteredEngine(int place, const PhotonMapEngine& engine) {
    register_once(engines(), place, engine);
}

const std::map<int, PhotonMapEngine>& photon_map_engines() {
    return engines();
}

std::string PhotonMapTechnique::name() const {
    return fmt::format("photonmap/{}/{}/{}", engine_->name, name_of(selection_),
                       kernel_names[static_cast<std::size_t>(kernel_)]);
}

nlohmann::ordered_json PhotonMapTechnique::fields() const {
    nlohmann::ordered_json fields = {{"family", "photonmap"},
                                     {"engine", engine_->name},
                                     {"selection", name_of(selection_)},
                                     {"kernel", kernel_names[static_cast<std::size_t>(kernel_)]}};
    if (const auto* nearest = std::get_if<photonmap::NearestPhotons>(&selection_))
        fields["nearest"] = nearest->count;
    else if (const auto* growing = std::get_if<photonmap::GrowingNumber>(&selection_))
        fields["growing_factor"] = growing->factor;
    else
        fields["diagonal_fraction"] = std::get<photonmap::FixedRadius>(selection_).diagonal_fraction;
    return fields;
}

std::string PhotonMapTechnique::store_key() const {
    if (!engine_->for_one_radius) return fmt::format("photonmap/{}", engine_->name);
    return fmt::format("photonmap/{}/{}", engine_->name, name_of(selection_));
}

double PhotonMapTechnique::needed_bytes(const ContenderSettings&, std::uint64_t hits) const {
    return static_cast<double>(hits) * engine_->bytes_per_hit;
}

std::unique_ptr<Store> PhotonMapTechnique::make_store(PreparedScene& scene,
                                                      const common::PhotonSource&) const {
    return engine_->make_store(scene.scene(), {selection_, kernel_, scene.settings().max_radius},
                               &scene.covers());
}

FinishedMap PhotonMapTechnique::finish(Store& store, const common::TraceReport& trace) const {
    auto& photons = static_cast<PhotonMapStore&>(store);
    return photons.finish(selection_, kernel_, trace);
}

}  // namespace bench
