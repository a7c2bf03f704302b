// The sink that becomes a light map.
#pragma once

#include <memory>

#include "shlm/light_map.h"

namespace shlm {

/// Everything about a scene's light map that does not depend on its light: made once, used by any number of
/// runs.
struct PreparedTexels {
    TexelLayout layout;
    std::vector<TexelGeometry> geometry;

    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels)
        : layout(scene, uv, texels), geometry(texel_geometry(scene, layout)) {}
};

class Sink {
  public:
    /// `texels` must outlive the sink.
    Sink(const PreparedTexels& texels, const Settings& settings)
        : texels_(&texels), settings_(settings), accumulator_(texels.layout, settings.weight) {}

    void consume(std::span<const common::HitBatch> wave) { accumulator_.consume(wave); }

    [[nodiscard]] LightMap finish(float watts_per_flux) && {
        return {accumulator_.sums(), texels_->geometry, watts_per_flux, settings_.nearest};
    }

    /// Hits that no texel of the finished map shows. Goes through all texels.
    [[nodiscard]] common::RejectedHits rejected() const {
        common::RejectedHits rejected = accumulator_.rejected();
        for (std::size_t i = 0; i < texels_->geometry.size(); ++i)
            if (texels_->geometry[i].area == 0) rejected.outside_texels += accumulator_.sums()[i].hits;
        return rejected;
    }
    [[nodiscard]] const Accumulator& accumulator() const { return accumulator_; }

  private:
    const PreparedTexels* texels_;
    Settings settings_;
    Accumulator accumulator_;
};

static_assert(common::MapSink<Sink>);

}  // namespace shlm
