// The sums of all texels, exact in any order, stored so that adding to one touches few cache lines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/core/huge_pages.h"
#include "common/core/prefetch.h"
#include "shlm/sums/quantum.h"

namespace shlm {

/// The sums of one texel: the model's numbers times texel area, summed over hits.
template <class Model>
struct TexelSum {
    /// Channel c of number i at [3 i + c]; W times the number of photons emitted.
    std::array<double, 3 * Model::summed> value{};
    std::uint64_t hits = 0;
};

/// Sums stay below this, so that recent sums can always be added to them. That is 10^11 hits on one texel,
/// each with all the scene's light at normal incidence.
inline constexpr std::int64_t max_texel_quanta = std::int64_t{1} << 62;

/// Throws InputError, so that no sum is ever silently wrong.
[[noreturn]] void throw_texel_is_full(std::size_t texel);

/// Each number of a hit is rounded once to whole quanta and then summed as an integer. So the sums are the
/// same to the bit for any order of hits, any number of threads and any division of a run, and equal
/// additions never stall. The error is that of rounding single hits: half a quantum and a float's last bit.
///
/// 64-bit sums would span twice the cache lines, and their misses are the cost of an addition. So hits go
/// into 32-bit sums, which are drained into 64-bit ones before they can overflow; `fill` bounds their
/// magnitude. Under uniform light this happens once in 100 to 200 hits. A hit too bright for 32 bits goes
/// straight to the 64-bit sums.
///
/// Chosen by measurement (bench/experiments/micro, sums/...; tests/shlm/texel_sums_test.cpp), order 2, random
/// texels:
///
///                        bytes  ns per add: 4096, 262144, 4 M texels  error after 3 2^24 equal adds
///   float                  128      9    17    40                       0.38: it stalls at 2^24
///   float into double      344     11    23    39                       4e-7; order shows in the last bits
///   double                 256     12    32    66                       5e-8; order shows in the last bits
///   int64                  256     13    33    72                       5e-8
///   int32 into int64       352     11    19    41                       5e-8; exact in any order
///
/// 5e-8 is the rounding error of the products, in float.
template <class Model>
class TexelSums {
  public:
    TexelSums(std::size_t texels, const Quantum& quantum)
        : quantum_(quantum), quanta_per_flux_(quantum.per_flux()), recent_(texels), drained_(texels) {}

    /// Prefetches the texel's cache lines for `add`.
    void prefetch(std::size_t texel) const { common::prefetch<common::PrefetchFor::writing>(recent_[texel]); }

    /// Adds one hit. `towards_light` is unit, `inverse_cosine` that of incidence, clamped. Throws InputError
    /// if a sum would leave its range.
    void add(std::size_t texel, const common::Vec3& towards_light, float inverse_cosine,
             const common::Rgb& flux) {
        const auto values = Model::of_hit(towards_light, inverse_cosine);
        const common::Rgb quanta = flux * quanta_per_flux_;
        std::array<float, 3 * Model::summed> product;
        for (std::size_t i = 0; i < Model::summed; ++i)
            for (int c = 0; c < 3; ++c) product[3 * i + c] = values[i] * quanta[c];

        RecentSum& sum = recent_[texel];
        const std::uint32_t fill = fill_of(quanta, Model::largest_of_hit(inverse_cosine));
        if (sum.fill + fill > max_fill) {
            drain(texel);
            if (fill > max_fill) return add_to_drained(texel, product);
        }
        for (std::size_t k = 0; k < product.size(); ++k)
            sum.quanta[k] += static_cast<std::int32_t>(std::rint(product[k]));
        sum.fill = static_cast<std::uint16_t>(sum.fill + fill);
        ++sum.hits;
    }

    [[nodiscard]] TexelSum<Model> operator[](std::size_t texel) const {
        TexelSum<Model> sum{.value = {}, .hits = hits(texel)};
        for (std::size_t k = 0; k < sum.value.size(); ++k)
            sum.value[k] = static_cast<double>(quanta(texel, k)) * quantum_.unit(k % 3);
        return sum;
    }

    /// Returns the sum itself, in quanta; k as in TexelSum::value.
    [[nodiscard]] std::int64_t quanta(std::size_t texel, std::size_t k) const {
        return drained_[texel].quanta[k] + recent_[texel].quanta[k];
    }

    [[nodiscard]] std::uint64_t hits(std::size_t texel) const {
        return drained_[texel].hits + recent_[texel].hits;
    }

    /// Adds the sum of another run, in the same quanta. Throws InputError as `add` does.
    void add_quanta(std::size_t texel, std::size_t k, std::int64_t quanta) {
        std::int64_t& sum = drained_[texel].quanta[k];
        if (__builtin_add_overflow(sum, quanta, &sum) || sum <= -max_texel_quanta || sum >= max_texel_quanta)
            throw_texel_is_full(texel);
    }
    void add_hits(std::size_t texel, std::uint64_t hits) { drained_[texel].hits += hits; }

    [[nodiscard]] std::size_t size() const { return recent_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return recent_.capacity() * sizeof(RecentSum) + drained_.capacity() * sizeof(drained_[0]);
    }

    static constexpr std::size_t bytes_per_texel() { return sizeof(RecentSum) + sizeof(DrainedSum); }

  private:
    /// The sums since the last drain.
    struct alignas(64) RecentSum {
        std::array<std::int32_t, 3 * Model::summed> quanta{};
        std::uint16_t hits = 0;  ///< each adds at least 1 to `fill`, so there are at most max_fill
        std::uint16_t fill = 0;  ///< no number's magnitude exceeds fill * quanta_per_fill
    };

    struct DrainedSum {
        std::array<std::int64_t, 3 * Model::summed> quanta{};
        std::uint64_t hits = 0;
    };

    static constexpr std::uint32_t max_fill = 0xffff;
    static constexpr float quanta_per_fill = 0x1p15f;  // max_fill of them are just below 2^31

    /// Returns what a hit adds to `fill`; more than max_fill for a hit that 32 bits cannot hold.
    /// Model::largest_of_hit leaves a hundredth of room for rounding.
    [[nodiscard]] static std::uint32_t fill_of(const common::Rgb& quanta, float largest_of_hit) {
        const float largest =
            std::max({std::abs(quanta.x), std::abs(quanta.y), std::abs(quanta.z)}) * largest_of_hit;
        constexpr float beyond = (max_fill + 1) * quanta_per_fill;
        return largest < beyond ? static_cast<std::uint32_t>(largest * (1 / quanta_per_fill)) + 1
                                : max_fill + 1;
    }

    void drain(std::size_t texel) {
        for (std::size_t k = 0; k < recent_[texel].quanta.size(); ++k)
            add_quanta(texel, k, recent_[texel].quanta[k]);
        drained_[texel].hits += recent_[texel].hits;
        recent_[texel] = {};
    }

    void add_to_drained(std::size_t texel, const std::array<float, 3 * Model::summed>& product) {
        for (std::size_t k = 0; k < product.size(); ++k) {
            if (!(std::abs(product[k]) < static_cast<float>(max_texel_quanta))) throw_texel_is_full(texel);
            add_quanta(texel, k, static_cast<std::int64_t>(std::rint(product[k])));
        }
        ++drained_[texel].hits;
    }

    Quantum quantum_;
    common::Rgb quanta_per_flux_;
    common::HugePageVector<RecentSum> recent_;
    common::HugePageVector<DrainedSum> drained_;
};

}  // namespace shlm
