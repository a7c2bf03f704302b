// Tests Sobol's points and their scrambling against the definitions of nets and of uniformity.
#include "common/core/scrambled_sobol.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/statistics.h"

namespace {

using common::ScrambledSobol;
using common::sobol_dimensions;

using Keys = std::array<std::uint32_t, sobol_dimensions>;

Keys any_keys(std::mt19937& engine) {
    Keys keys;
    for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(engine());
    return keys;
}

/// Returns coordinate `dimension` of points `first`, ... as 32 bits.
std::vector<std::uint32_t> points(std::size_t dimension, std::uint32_t first, std::uint32_t count,
                                  const Keys& keys) {
    std::vector<std::uint32_t> bits;
    for (std::uint32_t i = 0; i < count; ++i)
        bits.push_back(ScrambledSobol(first + i, keys).bits(dimension, (first + i) % ScrambledSobol::block));
    return bits;
}

/// 2^m consecutive points from a multiple of 2^m on have one point in each interval of length 2^-m.
TEST(ScrambledSobol, StratifiesEachCoordinate) {
    std::mt19937 engine(1);
    for (const std::uint32_t first : {0u, 1024u, 0x70000000u, 0xfffffc00u})
        for (std::size_t d = 0; d < sobol_dimensions; ++d) {
            std::set<std::uint32_t> intervals;
            for (const std::uint32_t bits : points(d, first, 1024, any_keys(engine)))
                intervals.insert(bits >> 22);
            EXPECT_EQ(intervals.size(), 1024u) << "dimension " << d << " from " << first;
        }
}

/// The first two coordinates form a (0, 2)-sequence: one point in each elementary rectangle.
TEST(ScrambledSobol, HasOnePointInEachElementaryRectangle) {
    std::mt19937 engine(2);
    constexpr unsigned m = 10;
    for (const std::uint32_t first : {0u, 5u << m, 0x80000000u}) {
        const Keys keys = any_keys(engine);
        const auto x = points(0, first, 1u << m, keys), y = points(1, first, 1u << m, keys);
        for (unsigned across = 0; across <= m; ++across) {
            std::set<std::uint32_t> rectangles;
            for (std::size_t i = 0; i < x.size(); ++i) {
                const std::uint32_t column = across == 0 ? 0 : x[i] >> (32 - across);
                const std::uint32_t row = across == m ? 0 : y[i] >> (32 - (m - across));
                rectangles.insert(column << (m - across) | row);
            }
            EXPECT_EQ(rectangles.size(), x.size()) << "2^" << across << " columns";
        }
    }
}

/// The first direction numbers in units of 1/64, as scipy 1.10's qmc.Sobol has them.
TEST(ScrambledSobol, HasTheDirectionNumbersOfJoeAndKuo) {
    constexpr std::array<std::array<std::uint32_t, 6>, sobol_dimensions> expected = {
        {{32, 16, 8, 4, 2, 1},
         {32, 48, 40, 60, 34, 51},
         {32, 48, 24, 36, 58, 23},
         {32, 48, 8, 20, 62, 29},
         {32, 16, 8, 44, 62, 55},
         {32, 16, 24, 12, 50, 9}}};
    for (std::size_t d = 0; d < sobol_dimensions; ++d)
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_EQ(common::sobol_tables::reversed(common::sobol_tables::of_bit[d][k]) >> 26,
                      expected[d][k])
                << "dimension " << d << ", bit " << k;
}

/// The key 0 leaves the first digit as it is. Over indices 0 to 3, van der Corput's sequence is 0, 1/2, 1/4,
/// 3/4, and Sobol's second coordinate 0, 1/2, 3/4, 1/4.
TEST(ScrambledSobol, IsSobolsSequenceWhereNothingIsFlipped) {
    const Keys zero{};
    for (const auto& [dimension, same] : {std::pair{0u, std::array{0u, 2u}}, {1u, std::array{0u, 3u}}}) {
        const auto bits = points(dimension, 0, 4, zero);
        EXPECT_EQ(bits[same[0]] >> 31, bits[same[1]] >> 31) << "dimension " << dimension;
        EXPECT_NE(bits[0] >> 31, bits[1] >> 31);
    }
}

/// Over keys, each point is uniform in 16 x 16 cells of two coordinates. Fails by chance less than once in
/// 1e5 runs.
TEST(ScrambledSobol, IsUniformOverKeys) {
    std::mt19937 engine(3);
    constexpr int runs = 40'000, cells = 256;
    for (const std::uint32_t index : {0u, 1u, 77u}) {
        std::array<int, cells> count{};
        for (int run = 0; run < runs; ++run) {
            const Keys keys = any_keys(engine);
            const ScrambledSobol sobol(index, keys);
            const std::uint32_t i = index % ScrambledSobol::block;
            ++count[(sobol.bits(2, i) >> 28) << 4 | sobol.bits(3, i) >> 28];
        }
        std::array<double, cells> expected;
        expected.fill(double{runs} / cells);
        EXPECT_GT(tests::chi_square_tail(tests::chi_square(count, expected), cells), 1e-5 / 3)
            << "index " << index;
    }
}

TEST(ScrambledSobol, GivesNumbersBelowOne) {
    std::mt19937 engine(4);
    for (int run = 0; run < 1000; ++run) {
        const Keys keys = any_keys(engine);
        const ScrambledSobol sobol(static_cast<std::uint32_t>(engine()), keys);
        for (std::size_t d = 0; d < sobol_dimensions; ++d)
            for (std::uint32_t i = 0; i < ScrambledSobol::block; ++i) {
                EXPECT_GE(sobol.uniform(d, i), 0);
                EXPECT_LT(sobol.uniform(d, i), 1);
            }
    }
}

}  // namespace
