// Sums of hits, one set per texel, in memory that does not grow.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include "shlm/deposit_sorter.h"
#include "shlm/settings.h"
#include "shlm/texel_sums.h"

namespace shlm {

template <class Model>
class Accumulator {
  public:
    explicit Accumulator(const TexelLayout& layout) : sorter_(layout), sums_(layout.texel_count()) {}

    /// Adds a wave's hits. Each texel gets its hits in the order of their photons, whatever the number of
    /// threads.
    void consume(std::span<const common::HitBatch> wave) {
        sorter_.sort(wave);
        tbb::parallel_for(std::size_t{0}, DepositSorter::max_shares,
                          [&](std::size_t share) { add(sorter_.share(share)); });
    }

    [[nodiscard]] const TexelSums<Model>& sums() const { return sums_; }
    [[nodiscard]] const common::RejectedHits& rejected() const { return sorter_.rejected(); }

    /// Nothing where the surface's irradiance does not come from a division by the cosine: with the flux
    /// weight, and where its exact sum is kept.
    [[nodiscard]] ClampedLight clamped() const {
        return Model::weight == ShWeight::radiance ? sorter_.clamped() : ClampedLight{};
    }

    /// The sums and what is kept to sort a wave by share.
    [[nodiscard]] std::size_t bytes() const { return sums_.bytes() + sorter_.bytes(); }

  private:
    /// A texel's sums are asked for this many deposits before they are added to: about the time of a cache
    /// miss.
    static constexpr std::size_t prefetch_distance = 16;

    void add(std::span<const Deposit> deposits) {
        for (std::size_t i = 0; i < deposits.size(); ++i) {
            if (i + prefetch_distance < deposits.size())
                sums_.prefetch(deposits[i + prefetch_distance].texel);
            const Deposit& deposit = deposits[i];
            sums_.add(deposit.texel, deposit.towards_light, deposit.inverse_cosine, deposit.flux);
        }
    }

    DepositSorter sorter_;
    TexelSums<Model> sums_;
};

}  // namespace shlm
