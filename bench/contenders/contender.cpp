#include "bench/contenders/contender.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bench/contenders/family.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/photon_map.h"

namespace bench {

void Store::add(const common::HitBatch&) {
    throw std::logic_error("this store takes whole waves only");
}

std::size_t Technique::most_photons() const {
    return std::numeric_limits<std::size_t>::max();
}

std::size_t Technique::texel_count(PreparedScene&) const {
    return 0;
}

const LightMapTechnique* Contender::light_map() const {
    return dynamic_cast<const LightMapTechnique*>(technique.get());
}

const PhotonMapTechnique* Contender::photon_map() const {
    return dynamic_cast<const PhotonMapTechnique*>(technique.get());
}

bool share_store(const Contender& a, const Contender& b) {
    return a->store_key() == b->store_key();
}

Contender parse_contender(const std::string& option, const std::string& name) {
    NameParts parts(option, name);
    const std::string family = parts.take("");
    const auto& families = all_families();
    const auto found = families.find(family);
    if (found == families.end()) {
        std::vector<std::string> names;
        for (const auto& [known, entry] : families) names.push_back(known);
        parts.complain(family, one_of(names));
    }
    std::shared_ptr<const Technique> technique = found->second.parse(parts);
    if (!parts.at_end()) parts.complain(parts.take(""), "expected after a whole name");
    return {technique->name(), std::move(technique)};
}

std::vector<Contender> parse_contenders(const std::string& option, const std::vector<std::string>& names) {
    std::vector<Contender> contenders;
    for (const std::string& name : names) {
        Contender contender = parse_contender(option, name);
        const auto same = [&](const Contender& c) { return c.name == contender.name; };
        if (std::none_of(contenders.begin(), contenders.end(), same))
            contenders.push_back(std::move(contender));
    }
    return contenders;
}

std::vector<ContenderGroup> groups_of(const std::vector<Contender>& contenders) {
    std::vector<ContenderGroup> groups;
    for (const Contender& contender : contenders) {
        if (groups.empty() || !share_store(groups.back().front(), contender)) groups.emplace_back();
        groups.back().push_back(contender);
    }
    return groups;
}

}  // namespace bench
