#include "bench/export/expanded_map.h"

#include "shlm/map/irradiance_mean.h"
#include "shlm/map/texel_lookup.h"

namespace bench {
namespace {

using Kept = shlm::HemisphereFit<2>;

/// What is read before the unit of the halves is known.
using ReadTexels = std::vector<std::optional<shlm::AdaptiveMap::FaceLight>>;

std::vector<std::uint32_t> finest_blocks(const shlm::AdaptiveMap& map, std::size_t regions) {
    std::vector<std::uint32_t> finest;
    for (std::uint32_t region = 0; region < regions; ++region)
        finest.push_back(std::max(map.finest_block(region), 1u));
    return finest;
}

/// Calls `use(texel, place in the fine layout)` for all texels of the region's faces, in their order.
template <class Use>
void for_texels(const shlm::TexelRegion& coarse, std::uint32_t region, std::uint32_t width, Use use) {
    std::uint32_t texel = coarse.first_texel;
    const auto middle = [&](std::uint32_t i) {
        return (static_cast<float>(i) + 0.5f) * static_cast<float>(width);
    };
    for (const bool back : {false, true}) {
        if (back && !coarse.both_faces) return;
        for (std::uint32_t y = 0; y < coarse.height; ++y)
            for (std::uint32_t x = 0; x < coarse.width; ++x)
                use(texel++, shlm::TexelPlace{region, back, {middle(x), middle(y)}});
    }
}

/// Returns the hits on all texels of the fine layout that a texel of `width` of them holds.
std::uint64_t hits_within(const shlm::TexelRegion& fine, const shlm::TexelPlace& place, std::uint32_t width,
                          const LightMapStore& store) {
    const auto left = static_cast<std::uint32_t>(place.at.x) / width * width,
               top = static_cast<std::uint32_t>(place.at.y) / width * width;
    std::uint64_t hits = 0;
    for (std::uint32_t y = top; y < std::min(top + width, fine.height); ++y)
        for (std::uint32_t x = left; x < std::min(left + width, fine.width); ++x)
            hits += store.hits(fine.first_texel_of(place.back) + y * fine.width + x);
    return hits;
}

StoredTexels in_halves(const ReadTexels& read, std::vector<std::uint64_t> hits) {
    float largest = 0;
    for (const auto& texel : read)
        if (texel)
            for (const common::Rgb& coefficient : texel->moments)
                for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(coefficient[c]));
    StoredTexels stored{
        shlm::number_count<Kept>, Kept::light_numbers, shlm::unit_for_halves(largest), {}, {}, {},
        std::move(hits)};
    stored.number.resize(read.size() * stored.numbers);
    stored.face.resize(read.size(), {common::Vec3(0, 0, 0), 0});
    stored.own.resize(read.size(), common::Rgb(0, 0, 0));
    for (std::size_t t = 0; t < read.size(); ++t) {
        if (!read[t]) continue;
        const auto& [normal, light] = *read[t];
        const Kept::Numbers numbers = Kept::numbers_of(light, normal);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            stored.number[t * numbers.size() + i] = shlm::half_of(numbers[i], stored.unit);
        stored.face[t] = {normal, 1};
        stored.own[t] = Kept::irradiance(numbers, normal, Kept::Question(normal));
    }
    return stored;
}

/// A map of the texels, to ask.
class TexelAnswers {
  public:
    explicit TexelAnswers(const ExpandedMap& map) : map_(map), lookup_(map.layout) {}

    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        const Kept::Question question(point.shading_normal);
        const StoredTexels& texels = map_.texels;
        shlm::IrradianceMean mean;
        lookup_.visit(
            point, [&](std::uint32_t t) { return texels.face[t]; },
            [&](std::uint32_t t, float weight) {
                Kept::Numbers numbers;
                for (std::size_t i = 0; i < numbers.size(); ++i)
                    numbers[i] = static_cast<float>(texels.number[t * numbers.size() + i]);
                mean.add(Kept::irradiance(numbers, texels.face[t].normal, question), weight);
            });
        return mean.irradiance() * texels.unit;
    }

    [[nodiscard]] std::size_t bytes() const { return map_.bytes(); }

  private:
    const ExpandedMap& map_;
    shlm::BilinearLookup lookup_;
};

}  // namespace

std::size_t ExpandedMap::bytes() const {
    return layout.texel_count() * sizeof(shlm::Texel<Kept, shlm::half>) + shlm::TexelPlaces(layout).bytes();
}

ExpandedMap expand(const shlm::AdaptiveMap& map, const shlm::TexelLayout& layout,
                   const LightMapStore& store) {
    const std::vector<std::uint32_t> finest = finest_blocks(map, layout.regions().size());
    shlm::TexelLayout coarse = layout.coarser(finest);
    ReadTexels read(coarse.texel_count());
    std::vector<std::uint64_t> hits(coarse.texel_count());
    for (std::uint32_t r = 0; r < finest.size(); ++r)
        for_texels(coarse.regions()[r], r, finest[r],
                   [&](std::uint32_t texel, const shlm::TexelPlace& place) {
                       read[texel] = map.light_at(place);
                       hits[texel] = hits_within(layout.regions()[r], place, finest[r], store);
                   });
    return {std::move(coarse), in_halves(read, std::move(hits))};
}

std::unique_ptr<const Answers> answers_of_texels(const ExpandedMap& map) {
    return answers_of(TexelAnswers(map));
}

}  // namespace bench
