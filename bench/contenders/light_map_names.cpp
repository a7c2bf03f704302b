#include "bench/contenders/light_map_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace bench {
namespace {

constexpr std::size_t most_texels = 1'000'000'000;

std::vector<LightMapKind>& kinds() {
    static std::vector<LightMapKind> all;
    return all;
}

}  // namespace

const LightBasis& basis_named(const std::string& name) {
    for (const auto& [place, basis] : light_bases())
        if (basis.name == name) return basis;
    throw std::logic_error("no light map's basis is called " + name);
}

std::string name_of(const shlm::Gather& gather) {
    if (const auto* nearest = std::get_if<shlm::NearestTexels>(&gather))
        return fmt::format("{}{}", nearest->of_own_surface ? "surface" : "knn", nearest->count);
    return std::holds_alternative<shlm::Bilinear>(gather) ? "bilinear" : "own";
}

void take_texels(NameParts& parts, TexelSetting& setting) {
    if (const std::string part = parts.peek(); part == "uv" || part == "face") {
        setting.placement = part == "uv" ? shlm::TexelPlacement::uv : shlm::TexelPlacement::face;
        (void)parts.take("");
    }
    if (const auto texels = count_after("t", parts.peek(), 1, most_texels)) {
        setting.texels = *texels;
        (void)parts.take("");
    }
}

const std::vector<LightMapKind>& light_map_kinds() {
    return kinds();
}

RegisteredLightMapKind::RegisteredLightMapKind(const LightMapKind& kind) {
    kinds().push_back(kind);
}

}  // namespace bench
