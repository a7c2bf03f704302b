#include "shlm/map/texel_lookup.h"

#include <numeric>

namespace shlm {
std::vector<std::uint32_t> OwnTexelLookup::held_texels(const PreparedTexels& texels) {
    std::vector<std::uint32_t> all(texels.geometry.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

std::vector<std::uint32_t> NearestTexelsLookup::held_texels(const PreparedTexels& texels) {
    std::vector<std::uint32_t> covered;
    for (std::size_t i = 0; i < texels.geometry.size(); ++i)
        if (texels.geometry[i].area > 0) covered.push_back(static_cast<std::uint32_t>(i));
    return covered;
}

TexelLookup make_lookup(const PreparedTexels& texels, const Gather& gather) {
    if (const auto* nearest = std::get_if<NearestTexels>(&gather))
        return NearestTexelsLookup(texels, *nearest);
    if (std::holds_alternative<Bilinear>(gather)) return BilinearLookup(texels, Bilinear{});
    return OwnTexelLookup(texels, OwnTexel{});
}

}  // namespace shlm
