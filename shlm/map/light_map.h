// The finished spherical harmonic light map: irradiance from the texels around a point (Good and Taylor
// 2005).
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "shlm/basis/harmonics.h"
#include "shlm/map/irradiance_mean.h"
#include "shlm/map/stored_texel.h"
#include "shlm/map/texel_blocks.h"
#include "shlm/sums/texel_sums.h"

namespace shlm {

/// Immutable. Its size does not depend on how many hits it has taken. `Number`, float or half, is the type
/// that it stores.
template <Basis B, class Number = float>
class LightMap {
  public:
    /// `sums` must have the layout of `texels`; `watts_per_flux` as in common::MapSink; `least_hits` as in
    /// TexelBlocks.
    template <class Model>
    LightMap(const TexelSums<Model>& sums, const PreparedTexels& texels, float watts_per_flux,
             const Gather& gather, std::uint64_t least_hits)
        : lookup_(make_lookup(texels, gather)) {
        std::vector<Texel<B>> finished = finished_texels(sums, texels, watts_per_flux, least_hits);
        if constexpr (std::is_same_v<Number, float>) {
            texels_ = std::move(finished);
        } else {
            unit_ = unit_for_halves<B>(finished);
            float largest_area = 0;
            for (const Texel<B>& texel : finished) largest_area = std::max(largest_area, texel.face.area);
            texels_.reserve(finished.size());
            for (const Texel<B>& texel : finished) texels_.push_back(in_halves(texel, unit_, largest_area));
        }
    }

    /// Returns irradiance for the shading normal, W/m^2: the weighted mean over the texels that the lookup
    /// finds. Never negative; zero if it finds none.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        const typename B::Question question(point.shading_normal);
        IrradianceMean mean;
        std::visit(
            [&](const auto& lookup) {
                lookup.visit(
                    point, [&](std::uint32_t i) { return texels_[i].face.unpacked(); },
                    [&](std::uint32_t i, float weight) {
                        const Texel<B, Number>& texel = texels_[i];
                        mean.add(B::irradiance(texel.numbers(), texel.face.unpacked().normal, question),
                                 weight);
                    });
            },
            lookup_);
        return mean.irradiance() * unit_;
    }

    [[nodiscard]] std::size_t bytes() const {
        return texels_.capacity() * sizeof(Texel<B, Number>) +
               std::visit([](const auto& lookup) { return lookup.bytes(); }, lookup_);
    }

    [[nodiscard]] std::span<const Texel<B, Number>> texels() const { return texels_; }

    /// Returns the unit of the texels' coefficients of light, W/m^2.
    [[nodiscard]] float unit() const { return unit_; }

  private:
    /// Returns the texels that the lookup holds, in its order.
    template <class Model>
    [[nodiscard]] std::vector<Texel<B>> finished_texels(const TexelSums<Model>& sums,
                                                        const PreparedTexels& texels, float watts_per_flux,
                                                        std::uint64_t least_hits) const {
        static_assert(Model::order == B::order);
        const std::vector<std::uint32_t> held =
            std::visit([&](const auto& lookup) { return lookup.held_texels(texels); }, lookup_);
        std::vector<std::uint32_t> place(texels.geometry.size(), no_texel);
        for (std::size_t i = 0; i < held.size(); ++i) place[held[i]] = static_cast<std::uint32_t>(i);

        std::vector<Texel<B>> finished(held.size());
        const auto show = [&](std::uint32_t texel, const TexelSum<Model>& sum, double area) {
            if (place[texel] == no_texel) return;
            const TexelGeometry& geometry = texels.geometry[texel];
            const TexelLight<B::order> light =
                finished_light<Model>(mean_of(sum, area, watts_per_flux), geometry.normal);
            finished[place[texel]] = {{geometry.normal, geometry.area},
                                      B::numbers_of(light, geometry.normal)};
        };
        TexelBlocks(sums, texels, least_hits, show).show_all();
        return finished;
    }

    /// Returns W/m^2 for each number of the sum.
    template <class Model>
    [[nodiscard]] static std::array<common::Rgb, Model::summed> mean_of(const TexelSum<Model>& sum,
                                                                        double area, float watts_per_flux) {
        const double scale = area > 0 ? static_cast<double>(watts_per_flux) / area : 0;
        std::array<common::Rgb, Model::summed> mean;
        for (std::size_t i = 0; i < Model::summed; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                mean[i][static_cast<int>(c)] = static_cast<float>(sum.value[3 * i + c] * scale);
        return mean;
    }

    TexelLookup lookup_;
    std::vector<Texel<B, Number>> texels_;
    float unit_ = 1;
};

/// The map that keeps all that a model sums.
template <class Model>
using HarmonicMap = LightMap<Harmonics<Model::order>>;

}  // namespace shlm
