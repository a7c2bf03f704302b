// Plain number formats to compare shlm::TexelSums with; they have its interface.
#pragma once

#include "common/core/prefetch.h"
#include "shlm/sums/texel_sums.h"

namespace bench {

/// Sums all texels in one array of one number type: floats, doubles, or quanta as 64-bit integers.
template <class Model, class Number>
class PlainSums {
  public:
    PlainSums(std::size_t texels, const shlm::Quantum& quantum)
        : quantum_(quantum), quanta_per_flux_(quantum.per_flux()), sums_(texels) {}

    void prefetch(std::size_t texel) const { common::prefetch<common::PrefetchFor::writing>(sums_[texel]); }

    void add(std::size_t texel, const common::Vec3& towards_light, float inverse_cosine,
             const common::Rgb& flux) {
        const auto values = Model::of_hit(towards_light, inverse_cosine);
        const common::Rgb scaled = exact ? flux * quanta_per_flux_ : flux;
        Sum& sum = sums_[texel];
        std::array<float, 3 * Model::summed> product;
        for (std::size_t i = 0; i < Model::summed; ++i)
            for (int c = 0; c < 3; ++c) product[3 * i + c] = values[i] * scaled[c];
        for (std::size_t k = 0; k < product.size(); ++k)
            sum.value[k] += static_cast<Number>(exact ? std::rint(product[k]) : product[k]);
        ++sum.hits;
    }

    /// Returns channel c of number i, where k = 3 i + c, in W times the number of photons emitted.
    [[nodiscard]] double value(std::size_t texel, std::size_t k) const {
        return static_cast<double>(sums_[texel].value[k]) * (exact ? quantum_.unit(k % 3) : 1);
    }

    static constexpr std::size_t bytes_per_texel() { return sizeof(Sum); }

  private:
    static constexpr bool exact = std::is_integral_v<Number>;

    struct alignas(64) Sum {
        std::array<Number, 3 * Model::summed> value{};
        std::uint64_t hits = 0;
    };

    shlm::Quantum quantum_;
    common::Rgb quanta_per_flux_;
    std::vector<Sum> sums_;
};

/// Sums in floats, which are added to doubles every 32 hits.
template <class Model>
class FloatsDrainedIntoDoubles {
  public:
    FloatsDrainedIntoDoubles(std::size_t texels, const shlm::Quantum&) : recent_(texels), drained_(texels) {}

    void prefetch(std::size_t texel) const { common::prefetch<common::PrefetchFor::writing>(recent_[texel]); }

    void add(std::size_t texel, const common::Vec3& towards_light, float inverse_cosine,
             const common::Rgb& flux) {
        const auto values = Model::of_hit(towards_light, inverse_cosine);
        RecentSum& sum = recent_[texel];
        std::array<float, numbers> product;
        for (std::size_t i = 0; i < Model::summed; ++i)
            for (int c = 0; c < 3; ++c) product[3 * i + c] = values[i] * flux[c];
        for (std::size_t k = 0; k < numbers; ++k) sum.value[k] += product[k];
        if (++sum.hits % hits_per_drain == 0) {
            for (std::size_t k = 0; k < numbers; ++k) drained_[texel][k] += sum.value[k];
            sum.value.fill(0);
        }
    }

    [[nodiscard]] double value(std::size_t texel, std::size_t k) const {
        return drained_[texel][k] + recent_[texel].value[k];
    }

    static constexpr std::size_t bytes_per_texel() { return sizeof(RecentSum) + sizeof(drained_[0]); }

  private:
    static constexpr std::size_t numbers = 3 * Model::summed;
    static constexpr std::uint64_t hits_per_drain = 32;

    struct alignas(64) RecentSum {
        std::array<float, numbers> value{};
        std::uint64_t hits = 0;
    };

    std::vector<RecentSum> recent_;
    std::vector<std::array<double, numbers>> drained_;
};

}  // namespace bench
