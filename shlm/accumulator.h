// Sums of hits, one set per texel, in memory that does not grow.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"
#include "shlm/settings.h"
#include "shlm/sh_basis.h"
#include "shlm/texel_layout.h"

namespace shlm {

/// Radiance coefficients times texel area: sum over hits of flux * weight * Y(direction towards the light).
/// Double, because float stops growing at 2^24 equal adds.
struct alignas(32) TexelSum {
    /// Channel c of harmonic i at [3 i + c]; W times the number of photons emitted.
    std::array<double, 3 * coefficient_count> coefficient{};
    std::uint64_t hits = 0;
};

class Accumulator {
  public:
    Accumulator(const TexelLayout& layout, ShWeight weight);

    /// Adds a wave's hits. Each texel gets its hits in the order of their photons, whatever the number of threads.
    void consume(std::span<const common::HitBatch> wave);

    [[nodiscard]] std::span<const TexelSum> sums() const { return sums_; }
    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }

    /// The sums and what is kept to sort a wave by texel.
    [[nodiscard]] std::size_t bytes() const;

  private:
    /// A hit on its way to its texel.
    struct Deposit {
        std::uint32_t texel;
        common::Vec3 towards_light;  ///< unit
        common::Rgb weight;          ///< what the harmonics are multiplied by
    };

    /// Deposits of one batch, grouped by the share of the texels that they fall in; in the batch's order within a share.
    struct SortedBatch {
        std::vector<Deposit> deposits;   ///< in the batch's order, rejected hits left out
        std::vector<Deposit> by_share;
        std::vector<std::uint32_t> share_begin;
        common::RejectedHits rejected;
    };

    void sort_by_share(const common::HitBatch& batch, SortedBatch& sorted) const;
    void add_share(std::size_t share, std::size_t batches);
    [[nodiscard]] std::size_t share_of(std::uint32_t texel) const { return texel >> share_shift_; }

    const TexelLayout* layout_;
    ShWeight weight_;
    unsigned share_shift_ = 0;
    std::size_t share_count_ = 0;
    std::vector<TexelSum> sums_;
    std::vector<SortedBatch> sorted_;
    common::RejectedHits rejected_;
};

static_assert(common::PhotonSink<Accumulator>);

}  // namespace shlm
