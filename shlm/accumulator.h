// Sums of hits, one set per texel, in memory that does not grow.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"
#include "shlm/settings.h"
#include "shlm/texel_layout.h"
#include "shlm/texel_sums.h"

namespace shlm {

class Accumulator {
  public:
    Accumulator(const TexelLayout& layout, ShWeight weight);

    /// Adds a wave's hits. Each texel gets its hits in the order of their photons, whatever the number of
    /// threads.
    void consume(std::span<const common::HitBatch> wave);

    [[nodiscard]] const TexelSums& sums() const { return sums_; }
    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }

    /// The sums and what is kept to sort a wave by share.
    [[nodiscard]] std::size_t bytes() const;

  private:
    /// Texels are dealt to threads in this many contiguous shares, at most. A share belongs to one thread at
    /// a time, so sums need no atomics; there are more shares than threads so that unequal ones even out.
    static constexpr std::size_t max_shares = 64;

    /// A hit on its way to its texel.
    struct Deposit {
        std::uint32_t texel;
        common::Vec3 towards_light;  ///< unit
        common::Rgb weight;          ///< what the harmonics are multiplied by
    };

    /// The deposits of one batch, in the batch's order; rejected hits left out.
    struct BatchDeposits {
        std::vector<Deposit> deposits;
        std::array<std::uint32_t, max_shares> share_size;   ///< how many fall in each share of the texels
        std::array<std::uint32_t, max_shares> share_begin;  ///< where they go in `by_share_`
        common::RejectedHits rejected;
    };

    void find_texels(const common::HitBatch& hits, BatchDeposits& batch) const;
    void place_batches(std::size_t batch_count);
    void scatter_to_shares(BatchDeposits& batch);
    void add_share(std::size_t share);
    [[nodiscard]] std::size_t share_of(std::uint32_t texel) const { return texel >> share_shift_; }

    const TexelLayout* layout_;
    ShWeight weight_;
    unsigned share_shift_ = 0;
    TexelSums sums_;
    std::vector<BatchDeposits> batches_;
    std::vector<Deposit> by_share_;  ///< the wave's, share after share, each in the photons' order
    std::array<std::uint32_t, max_shares + 1> share_begin_;  ///< in `by_share_`
    common::RejectedHits rejected_;
};

static_assert(common::PhotonSink<Accumulator>);

}  // namespace shlm
