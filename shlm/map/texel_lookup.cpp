#include "shlm/map/texel_lookup.h"

#include <numeric>

namespace shlm {
namespace {

std::vector<common::Vec3> covered_centers(const PreparedTexels& texels) {
    std::vector<common::Vec3> centers;
    for (const TexelGeometry& texel : texels.geometry)
        if (texel.area > 0) centers.push_back(texel.center);
    centers.shrink_to_fit();
    return centers;
}

std::vector<std::uint32_t> pieces_of_covered(const PreparedTexels& texels) {
    std::vector<std::uint32_t> pieces;
    for (const TexelGeometry& texel : texels.geometry)
        if (texel.area > 0) pieces.push_back(texel.piece);
    pieces.shrink_to_fit();
    return pieces;
}

}  // namespace

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

NearestTexelsLookup::NearestTexelsLookup(const PreparedTexels& texels, NearestTexels nearest)
    : pieces_(nearest.of_own_surface ? texels.pieces : nullptr),
      piece_(nearest.of_own_surface ? pieces_of_covered(texels) : std::vector<std::uint32_t>{}),
      centers_(covered_centers(texels)),
      index_(centers_),
      count_(nearest.count),
      max_radius_(static_cast<float>(4 * texel_width(texels.geometry))) {}

TexelLookup make_lookup(const PreparedTexels& texels, const Gather& gather) {
    if (const auto* nearest = std::get_if<NearestTexels>(&gather))
        return NearestTexelsLookup(texels, *nearest);
    if (std::holds_alternative<Bilinear>(gather)) return BilinearLookup(texels, Bilinear{});
    return OwnTexelLookup(texels, OwnTexel{});
}

}  // namespace shlm
