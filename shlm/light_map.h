// The finished spherical harmonic light map: irradiance from the texels around a point (Good and Taylor
// 2005).
#pragma once

#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "shlm/texel_blocks.h"
#include "shlm/texel_lookup.h"
#include "shlm/texel_model.h"
#include "shlm/texel_sums.h"

namespace shlm {

/// A texel that a gather can find.
template <class Model>
struct Texel {
    TexelFace face;
    TexelLight<Model> light;
};

/// Immutable. Its size does not depend on how many hits it has taken.
template <class Model>
class LightMap {
  public:
    /// `sums` are of the same layout as `texels`, which must outlive the map; `watts_per_flux` as in
    /// common::MapSink; `least_hits` as in TexelBlocks.
    LightMap(const TexelSums<Model>& sums, const PreparedTexels& texels, float watts_per_flux,
             const Gather& gather, std::uint64_t least_hits)
        : lookup_(make_lookup(texels, gather)),
          texels_(finished_texels(sums, texels, watts_per_flux, least_hits)) {}

    /// Irradiance for the shading normal, W/m^2: the weighted mean over the texels that the lookup finds.
    /// Never negative. Zero where it finds none.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        TexelMean<Model> mean(point.shading_normal);
        std::visit(
            [&](const auto& lookup) {
                lookup.visit(
                    point, [&](std::uint32_t i) -> const TexelFace& { return texels_[i].face; },
                    [&](std::uint32_t i, float weight) { mean.add(texels_[i].light, weight); });
            },
            lookup_);
        return mean.irradiance();
    }

    [[nodiscard]] std::size_t bytes() const {
        return texels_.capacity() * sizeof(Texel<Model>) +
               std::visit([](const auto& lookup) { return lookup.bytes(); }, lookup_);
    }

    [[nodiscard]] std::span<const Texel<Model>> texels() const { return texels_; }

  private:
    /// Those that the lookup holds, in its order.
    [[nodiscard]] std::vector<Texel<Model>> finished_texels(const TexelSums<Model>& sums,
                                                            const PreparedTexels& texels,
                                                            float watts_per_flux,
                                                            std::uint64_t least_hits) const {
        const std::vector<std::uint32_t> held =
            std::visit([&](const auto& lookup) { return lookup.held_texels(texels); }, lookup_);
        std::vector<std::uint32_t> place(texels.geometry.size(), no_texel);
        for (std::size_t i = 0; i < held.size(); ++i) place[held[i]] = static_cast<std::uint32_t>(i);

        std::vector<Texel<Model>> finished(held.size());
        const auto show = [&](std::uint32_t texel, const TexelSum<Model>& sum, double area) {
            if (place[texel] == no_texel) return;
            const TexelGeometry& geometry = texels.geometry[texel];
            const double scale = area > 0 ? static_cast<double>(watts_per_flux) / area : 0;
            std::array<common::Rgb, Model::summed> mean;
            for (std::size_t i = 0; i < Model::summed; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    mean[i][static_cast<int>(c)] = static_cast<float>(sum.value[3 * i + c] * scale);
            finished[place[texel]] = {{geometry.normal, geometry.area},
                                      finished_light<Model>(mean, geometry.normal)};
        };
        TexelBlocks(sums, texels, least_hits, show).show_all();
        return finished;
    }

    TexelLookup lookup_;
    std::vector<Texel<Model>> texels_;
};

}  // namespace shlm
