// The sink that becomes a light map.
#pragma once

#include "common/tracer/rejected_hits.h"
#include "shlm/map/light_map.h"
#include "shlm/sums/accumulator.h"

namespace shlm {

template <class Model>
class Sink {
  public:
    /// `texels` must outlive the sink; `least_hits` as in TexelBlocks.
    Sink(const PreparedTexels& texels, const Gather& gather, const Quantum& quantum,
         std::uint64_t least_hits = default_least_hits)
        : texels_(&texels), gather_(gather), least_hits_(least_hits), accumulator_(texels.layout, quantum) {}

    void consume(std::span<const common::HitBatch> wave) { accumulator_.consume(wave); }
    void add(const common::HitBatch& hits) { accumulator_.add(hits); }

    [[nodiscard]] HarmonicMap<Model> finish(float watts_per_flux) const {
        return finish(watts_per_flux, gather_, least_hits_);
    }

    /// Returns a map of the same light in another basis, with another type of numbers or another gather.
    template <Basis B = Harmonics<Model::order>, class Number = float>
    [[nodiscard]] LightMap<B, Number> finish(float watts_per_flux, const Gather& gather,
                                             std::uint64_t least_hits) const {
        return {accumulator_.sums(), *texels_, watts_per_flux, gather, least_hits};
    }

    /// Returns the hits that no texel of the finished map shows. Visits all texels.
    [[nodiscard]] common::RejectedHits rejected() const {
        common::RejectedHits rejected = accumulator_.rejected();
        for (std::size_t i = 0; i < texels_->geometry.size(); ++i)
            if (texels_->geometry[i].area == 0) rejected.outside_texels += accumulator_.sums().hits(i);
        return rejected;
    }
    [[nodiscard]] std::size_t bytes() const { return accumulator_.bytes(); }
    [[nodiscard]] const PreparedTexels& texels() const { return *texels_; }
    [[nodiscard]] const Accumulator<Model>& accumulator() const { return accumulator_; }
    [[nodiscard]] Accumulator<Model>& accumulator() { return accumulator_; }

  private:
    const PreparedTexels* texels_;
    Gather gather_;
    std::uint64_t least_hits_;
    Accumulator<Model> accumulator_;
};

/// The model of the paper, with the weight that makes it right.
using PaperModel = TexelModel<2, ShWeight::radiance>;

static_assert(common::MapSink<Sink<PaperModel>> && common::UnorderedSink<Sink<PaperModel>>);
static_assert(common::IrradianceEstimator<HarmonicMap<PaperModel>>);

}  // namespace shlm
