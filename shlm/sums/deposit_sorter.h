// Finds the texels of a batch's hits, and sorts the hits by share of the texels.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"
#include "shlm/layout/texel_layout.h"
#include "shlm/sums/clamped_light.h"

namespace shlm {

/// The texel of a hit, and what its HitBatch does not contain.
struct Deposit {
    std::uint32_t hit;  ///< index in its batch
    std::uint32_t texel;
    float inverse_cosine;  ///< of incidence on the triangle, clamped by common::min_incident_cosine
};

/// Must be used by one thread only: keeps its working arrays, and counts what it leaves out.
class DepositSorter {
  public:
    /// Texels are divided into at most this many contiguous shares. One thread at a time adds to a share, so
    /// sums need no atomics. With many more shares than threads, threads seldom wait for each other.
    static constexpr std::size_t max_shares = 64;

    /// `layout` must outlive the sorter.
    DepositSorter(const TexelLayout& layout, const Quantum& quantum);

    /// Replaces the deposits by those of another batch. Counts the hits that have no texel, and leaves them
    /// out.
    void sort(const common::HitBatch& hits);

    /// Returns the batch's deposits, share after share.
    [[nodiscard]] std::span<const Deposit> deposits() const { return by_share_; }

    /// Returns where share `index` begins in `deposits`; it ends where the next one begins.
    [[nodiscard]] std::size_t share_begin(std::size_t index) const { return share_begin_[index]; }

    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }
    [[nodiscard]] const ClampedLight& clamped() const { return clamped_; }

  private:
    void find_texels(const common::HitBatch& hits);
    void deal_out();
    [[nodiscard]] std::size_t share_of(std::uint32_t texel) const { return texel >> share_shift_; }

    const TexelLayout* layout_;
    float clamped_light_per_flux_;
    unsigned share_shift_ = 0;
    std::vector<Deposit> deposits_;  ///< in the batch's order
    std::vector<Deposit> by_share_;
    std::array<std::uint32_t, max_shares + 1> share_begin_{};  ///< in `by_share_`
    common::RejectedHits rejected_;
    ClampedLight clamped_;
};

}  // namespace shlm
