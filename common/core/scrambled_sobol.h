// Points of Sobol's sequence with Owen's nested uniform scrambling.
#pragma once

#include <array>
#include <cstdint>

namespace common {

inline constexpr std::size_t sobol_dimensions = 6;

namespace sobol_tables {

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    return x << 24 | (x & 0xff00u) << 8 | (x >> 8 & 0xff00u) | x >> 24;
}

/// A primitive polynomial over GF(2): its degree, its inner coefficients as bits, and the first direction
/// numbers, as many as its degree (Joe and Kuo, "Constructing Sobol sequences with better two-dimensional
/// projections", 2008, table new-joe-kuo-6, dimensions 2 to 6).
struct Polynomial {
    unsigned degree, coefficients;
    std::array<std::uint32_t, 4> first;
};
inline constexpr std::array<Polynomial, sobol_dimensions - 1> polynomials = {
    {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}}}};

/// Direction numbers of a dimension, bit k for bit k of the index; the first binary digit is the lowest bit.
constexpr std::array<std::uint32_t, 32> directions(std::size_t dimension) {
    std::array<std::uint32_t, 32> v{};  // with the first digit highest, as usual
    if (dimension == 0) {
        for (unsigned k = 0; k < 32; ++k) v[k] = 0x80000000u >> k;
    } else {
        const auto& [degree, coefficients, first] = polynomials[dimension - 1];
        for (unsigned k = 0; k < 32; ++k) {
            if (k < degree) {
                v[k] = first[k] << (31 - k);
                continue;
            }
            v[k] = v[k - degree] ^ v[k - degree] >> degree;
            for (unsigned j = 1; j < degree; ++j)
                if (coefficients >> (degree - 1 - j) & 1) v[k] ^= v[k - j];
        }
    }
    for (std::uint32_t& number : v) number = reversed(number);
    return v;
}

/// As above, for all dimensions.
inline constexpr auto of_bit = [] {
    std::array<std::array<std::uint32_t, 32>, sobol_dimensions> all{};
    for (std::size_t d = 0; d < all.size(); ++d) all[d] = directions(d);
    return all;
}();

/// The points of the first 64 indices, by dimension.
inline constexpr auto of_low_bits = [] {
    std::array<std::array<std::uint32_t, 64>, sobol_dimensions> all{};
    for (std::size_t d = 0; d < all.size(); ++d)
        for (std::uint32_t i = 0; i < 64; ++i)
            for (unsigned k = 0; k < 6; ++k)
                if (i >> k & 1) all[d][i] ^= of_bit[d][k];
    return all;
}();

}  // namespace sobol_tables

/// Points whose indices share all but their lowest six bits, in the unit cube. Each coordinate is scrambled
/// by a key of its own: digit k is flipped or not, depending on the key and the digits before it. So every
/// point is uniform, while each 2^m consecutive points from a multiple of 2^m on are as evenly spread as
/// before (Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995).
class ScrambledSobol {
  public:
    static constexpr std::uint32_t block = 64;

    /// `index` is any of the block's.
    ScrambledSobol(std::uint32_t index, const std::array<std::uint32_t, sobol_dimensions>& keys)
        : keys_(keys) {
        for (std::size_t d = 0; d < sobol_dimensions; ++d)
            for (unsigned k = 6; k < 32; ++k)
                if (index >> k & 1) base_[d] ^= sobol_tables::of_bit[d][k];
    }

    /// Returns a coordinate of the block's point `i` < 64, in units of 2^-32.
    [[nodiscard]] std::uint32_t bits(std::size_t dimension, std::uint32_t i) const {
        return sobol_tables::reversed(
            scrambled(base_[dimension] ^ sobol_tables::of_low_bits[dimension][i], keys_[dimension]));
    }

    /// Returns the same as a number in [0, 1), cut to the 24 bits of a float.
    [[nodiscard]] float uniform(std::size_t dimension, std::uint32_t i) const {
        return static_cast<float>(bits(dimension, i) >> 8) * 0x1p-24f;
    }

  private:
    /// A hash in which each bit of the result depends on the lower bits alone (Laine and Karras, "Stratified
    /// sampling for stochastic transparency", 2011), with Vegdahl's constants (2021), which scramble as
    /// evenly as true random flips.
    static std::uint32_t scrambled(std::uint32_t x, std::uint32_t key) {
        x ^= x * 0x3d20adeau;
        x += key;
        x *= key >> 16 | 1;
        x ^= x * 0x05526c56u;
        x ^= x * 0x53a22864u;
        return x;
    }

    std::array<std::uint32_t, sobol_dimensions> keys_, base_{};
};

}  // namespace common
