// The sums of all texels, kept so that adding to one touches two cache lines and no sum ever stalls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/core/vector.h"
#include "shlm/sh_basis.h"

namespace shlm {

/// What one texel has taken: radiance coefficients times texel area, the sum over hits of
/// flux * weight * Y(direction towards the light).
struct TexelSum {
    /// Channel c of harmonic i at [3 i + c]; W times the number of photons emitted.
    std::array<double, 3 * coefficient_count> coefficient{};
    std::uint64_t hits = 0;
};

/// A float stops growing at 2^24 equal adds, but a texel of doubles spans four cache lines, and their misses
/// are what an add costs. So hits are summed in floats, on two lines, and every 32 hits the texel's floats
/// are drained into doubles. The error is that of summing 32 floats; the order of one texel's adds decides
/// the result to the bit.
class TexelSums {
  public:
    explicit TexelSums(std::size_t texels) : recent_(texels), drained_(texels) {}

    /// Asks for the texel's cache lines ahead of `add`.
    void prefetch(std::size_t texel) const {
        const char* address = reinterpret_cast<const char*>(&recent_[texel]);
        __builtin_prefetch(address, 1);
        __builtin_prefetch(address + 64, 1);
    }

    /// Adds one hit: `weight` times the harmonics in the direction `towards_light` (unit).
    void add(std::size_t texel, const common::Vec3& towards_light, const common::Rgb& weight) {
        RecentSum& sum = recent_[texel];
        const ShValues y = evaluate_sh(towards_light);
        std::array<float, 3 * coefficient_count> product;
        for (std::size_t i = 0; i < coefficient_count; ++i)
            for (int c = 0; c < 3; ++c) product[3 * i + c] = y[i] * weight[c];
        for (std::size_t k = 0; k < product.size(); ++k) sum.coefficient[k] += product[k];
        if (++sum.hits % hits_per_drain == 0) drain(texel);
    }

    [[nodiscard]] TexelSum operator[](std::size_t texel) const {
        TexelSum sum{drained_[texel], recent_[texel].hits};
        for (std::size_t k = 0; k < sum.coefficient.size(); ++k)
            sum.coefficient[k] += recent_[texel].coefficient[k];
        return sum;
    }

    [[nodiscard]] std::size_t size() const { return recent_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return recent_.capacity() * sizeof(RecentSum) + drained_.capacity() * sizeof(drained_[0]);
    }

    static constexpr std::size_t bytes_per_texel() { return sizeof(RecentSum) + sizeof(DrainedSum); }

  private:
    static constexpr std::uint64_t hits_per_drain = 32;

    using DrainedSum = std::array<double, 3 * coefficient_count>;

    struct alignas(64) RecentSum {
        std::array<float, 3 * coefficient_count> coefficient{};
        std::uint64_t hits = 0;  ///< all of them, drained ones included
    };

    void drain(std::size_t texel) {
        for (std::size_t k = 0; k < drained_[texel].size(); ++k)
            drained_[texel][k] += recent_[texel].coefficient[k];
        recent_[texel].coefficient.fill(0);
    }

    std::vector<RecentSum> recent_;
    std::vector<DrainedSum> drained_;
};

}  // namespace shlm
