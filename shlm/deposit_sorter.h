// A wave's hits, each with its texel, dealt out so that threads can add them without atomics.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"
#include "shlm/texel_layout.h"

namespace shlm {

/// A hit on its way to its texel.
struct Deposit {
    std::uint32_t texel;
    common::Vec3 towards_light;  ///< unit
    float inverse_cosine;        ///< of incidence on the triangle, clamped by common::min_incident_cosine
    common::Rgb flux;            ///< as in common::HitBatch
};

/// What the clamp of the cosine takes away.
struct ClampedLight {
    double flux = 0;       ///< of all stored hits, mean of the channels; W times the number of photons
    double discarded = 0;  ///< part of it that the surface's irradiance lacks: F (1 - cos theta / clamp)

    [[nodiscard]] double discarded_share() const { return flux > 0 ? discarded / flux : 0; }

    ClampedLight& operator+=(const ClampedLight& other) {
        flux += other.flux;
        discarded += other.discarded;
        return *this;
    }
};

class DepositSorter {
  public:
    /// Texels are dealt to threads in this many contiguous shares, at most. A share belongs to one thread at
    /// a time, so sums need no atomics; there are more shares than threads so that unequal ones even out.
    static constexpr std::size_t max_shares = 64;

    explicit DepositSorter(const TexelLayout& layout);

    /// Replaces the deposits by those of another wave; hits that have no texel are counted and left out. Uses
    /// the threads of the calling arena.
    void sort(std::span<const common::HitBatch> wave);

    /// The wave's deposits into one share of the texels, in the order of their photons.
    [[nodiscard]] std::span<const Deposit> share(std::size_t index) const {
        return std::span(by_share_).subspan(share_begin_[index],
                                            share_begin_[index + 1] - share_begin_[index]);
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }
    [[nodiscard]] const ClampedLight& clamped() const { return clamped_; }
    [[nodiscard]] std::size_t bytes() const;

  private:
    /// The deposits of one batch, in the batch's order; rejected hits left out.
    struct BatchDeposits {
        std::vector<Deposit> deposits;
        std::array<std::uint32_t, max_shares> share_size;   ///< how many fall in each share of the texels
        std::array<std::uint32_t, max_shares> share_begin;  ///< where they go in `by_share_`
        common::RejectedHits rejected;
        ClampedLight clamped;
    };

    void find_texels(const common::HitBatch& hits, BatchDeposits& batch) const;
    void place_batches(std::size_t batch_count);
    void scatter_to_shares(BatchDeposits& batch);
    [[nodiscard]] std::size_t share_of(std::uint32_t texel) const { return texel >> share_shift_; }

    const TexelLayout* layout_;
    unsigned share_shift_ = 0;
    std::vector<BatchDeposits> batches_;
    std::vector<Deposit> by_share_;  ///< the wave's, share after share, each in the photons' order
    std::array<std::uint32_t, max_shares + 1> share_begin_{};  ///< in `by_share_`
    common::RejectedHits rejected_;
    ClampedLight clamped_;
};

}  // namespace shlm
