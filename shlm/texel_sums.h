// The sums of all texels, kept so that adding to one touches few cache lines and no sum ever stalls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/core/vector.h"

namespace shlm {

/// What one texel has taken: the model's numbers times texel area, summed over hits.
template <class Model>
struct TexelSum {
    /// Channel c of number i at [3 i + c]; W times the number of photons emitted.
    std::array<double, 3 * Model::summed> value{};
    std::uint64_t hits = 0;
};

/// A float stops growing at 2^24 equal adds, but a texel of doubles spans twice the cache lines, and their
/// misses are what an add costs. So hits are summed in floats, and every 32 hits the texel's floats are
/// drained into doubles. The error is that of summing 32 floats; the order of one texel's adds decides the
/// result to the bit.
template <class Model>
class TexelSums {
  public:
    explicit TexelSums(std::size_t texels) : recent_(texels), drained_(texels) {}

    /// Asks for the texel's cache lines ahead of `add`.
    void prefetch(std::size_t texel) const {
        const char* address = reinterpret_cast<const char*>(&recent_[texel]);
        for (std::size_t line = 0; line < sizeof(RecentSum); line += 64)
            __builtin_prefetch(address + line, 1);
    }

    /// Adds one hit. `towards_light` is unit, `inverse_cosine` that of incidence, clamped.
    void add(std::size_t texel, const common::Vec3& towards_light, float inverse_cosine,
             const common::Rgb& flux) {
        RecentSum& sum = recent_[texel];
        const auto values = Model::of_hit(towards_light, inverse_cosine);
        std::array<float, 3 * Model::summed> product;
        for (std::size_t i = 0; i < Model::summed; ++i)
            for (int c = 0; c < 3; ++c) product[3 * i + c] = values[i] * flux[c];
        for (std::size_t k = 0; k < product.size(); ++k) sum.value[k] += product[k];
        if (++sum.hits % hits_per_drain == 0) drain(texel);
    }

    [[nodiscard]] TexelSum<Model> operator[](std::size_t texel) const {
        TexelSum<Model> sum{drained_[texel], recent_[texel].hits};
        for (std::size_t k = 0; k < sum.value.size(); ++k) sum.value[k] += recent_[texel].value[k];
        return sum;
    }

    [[nodiscard]] std::size_t size() const { return recent_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return recent_.capacity() * sizeof(RecentSum) + drained_.capacity() * sizeof(drained_[0]);
    }

    static constexpr std::size_t bytes_per_texel() { return sizeof(RecentSum) + sizeof(DrainedSum); }

  private:
    static constexpr std::uint64_t hits_per_drain = 32;

    using DrainedSum = std::array<double, 3 * Model::summed>;

    struct alignas(64) RecentSum {
        std::array<float, 3 * Model::summed> value{};
        std::uint64_t hits = 0;  ///< all of them, drained ones included
    };

    void drain(std::size_t texel) {
        for (std::size_t k = 0; k < drained_[texel].size(); ++k)
            drained_[texel][k] += recent_[texel].value[k];
        recent_[texel].value.fill(0);
    }

    std::vector<RecentSum> recent_;
    std::vector<DrainedSum> drained_;
};

}  // namespace shlm
