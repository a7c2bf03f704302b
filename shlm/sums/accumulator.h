// Sums of hits, one set per texel, in memory of constant size.
#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/spin_mutex.h>

#include <bitset>
#include <memory>

#include "common/tracer/rejected_hits.h"
#include "shlm/basis/weight.h"
#include "shlm/sums/deposit_sorter.h"
#include "shlm/sums/texel_sums.h"

namespace shlm {

template <class Model>
class Accumulator {
  public:
    /// `layout` must outlive the accumulator.
    Accumulator(const TexelLayout& layout, const Quantum& quantum)
        : sorters_([&layout, quantum] { return DepositSorter(layout, quantum); }),
          sums_(layout.texel_count(), quantum),
          shares_(std::make_unique<std::array<Share, DepositSorter::max_shares>>()) {}

    /// Adds a batch's hits; several threads may do so at once.
    void add(const common::HitBatch& hits) {
        DepositSorter& sorter = sorters_.local();
        sorter.sort(hits);
        std::bitset<DepositSorter::max_shares> done;
        // First the shares that are free; those that another thread is adding to come later.
        for (std::size_t share = 0; share < DepositSorter::max_shares; ++share) {
            tbb::spin_mutex::scoped_lock lock;
            if (!lock.try_acquire((*shares_)[share].mutex)) continue;
            add(hits, sorter, share);
            done.set(share);
        }
        for (std::size_t share = 0; share < DepositSorter::max_shares; ++share) {
            if (done[share]) continue;
            const tbb::spin_mutex::scoped_lock lock((*shares_)[share].mutex);
            add(hits, sorter, share);
        }
    }

    void consume(std::span<const common::HitBatch> wave) {
        tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { add(wave[b]); });
    }

    [[nodiscard]] const TexelSums<Model>& sums() const { return sums_; }

    [[nodiscard]] common::RejectedHits rejected() const {
        common::RejectedHits rejected = earlier_rejected_;
        for (const DepositSorter& sorter : sorters_) rejected += sorter.rejected();
        return rejected;
    }

    /// Returns zero if the surface's irradiance does not come from a division by the cosine: with the flux
    /// weight, and where its exact sum is kept.
    [[nodiscard]] ClampedLight clamped() const {
        ClampedLight clamped = earlier_clamped_;
        if (Model::weight == ShWeight::radiance)
            for (const DepositSorter& sorter : sorters_) clamped += sorter.clamped();
        return clamped;
    }

    /// To take over what another run has stored and what it has rejected.
    [[nodiscard]] TexelSums<Model>& sums() { return sums_; }
    void add_counts(const common::RejectedHits& rejected, const ClampedLight& clamped) {
        earlier_rejected_ += rejected;
        earlier_clamped_ += clamped;
    }

    /// Returns the memory of the sums. Each thread uses some 100 KiB more, depending on the size of its
    /// batches.
    [[nodiscard]] std::size_t bytes() const { return sums_.bytes(); }

  private:
    /// A texel's sums are prefetched this many deposits before they are added to: about the time of a cache
    /// miss.
    static constexpr std::size_t prefetch_distance = 16;

    struct alignas(64) Share {
        tbb::spin_mutex mutex;
    };

    void add(const common::HitBatch& hits, const DepositSorter& sorter, std::size_t share) {
        const std::span<const Deposit> deposits = sorter.deposits();
        const std::size_t end = sorter.share_begin(share + 1);
        for (std::size_t i = sorter.share_begin(share); i < end; ++i) {
            // Past the share's end too, as the next share usually comes next.
            if (i + prefetch_distance < deposits.size())
                sums_.prefetch(deposits[i + prefetch_distance].texel);
            const Deposit& deposit = deposits[i];
            sums_.add(deposit.texel, -hits.direction[deposit.hit], deposit.inverse_cosine,
                      hits.flux[deposit.hit]);
        }
    }

    tbb::enumerable_thread_specific<DepositSorter> sorters_;
    TexelSums<Model> sums_;
    std::unique_ptr<std::array<Share, DepositSorter::max_shares>> shares_;
    common::RejectedHits earlier_rejected_;
    ClampedLight earlier_clamped_;
};

}  // namespace shlm
