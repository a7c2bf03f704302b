#include "common/core/random.h"

#include <gtest/gtest.h>

#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::random_uniforms;
using common::RandomPurpose;

constexpr std::uint64_t draws = count_for(1'000'000, 100'000);

TEST(Random, IsPhilox) {
    // Philox4x32-10 of counter 0 and key 0: the known answer that is part of Random123.
    const std::array<std::uint32_t, 4> bits = {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8};
    const auto u = random_uniforms(0, 0, 0, RandomPurpose::emission_origin);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(u[i], static_cast<float>(bits[i] >> 8) / 16777216.0f);
}

TEST(Random, IsUniformAndNeverOne) {
    constexpr std::uint64_t seed = 1;
    constexpr std::size_t bins = 257;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        std::array<std::uint64_t, bins> counts{};
        for (std::uint64_t i = 0; i < draws; ++i) {
            const float u = random_uniforms(seed, i, 0, RandomPurpose::scattering)[lane];
            ASSERT_GE(u, 0.0f);
            ASSERT_LT(u, 1.0f);
            ++counts[static_cast<std::size_t>(u * bins)];
        }
        const std::vector<double> expected(bins, static_cast<double>(draws) / bins);
        EXPECT_GT(chi_square_tail(chi_square(counts, expected), bins - 1), 1e-5)
            << "lane " << lane << ", seed " << seed;
    }
}

TEST(Random, ReachesTheLargestFloatBelowOne) {
    // The upper 24 bits are all set here; scaling 32 of them may round up to 1.
    EXPECT_EQ(random_uniforms(1, 10'223'920, 0, RandomPurpose::emission_direction)[0], 1 - 0x1p-24f);
}

/// Draws pairs of numbers that must be independent, and counts them in all cells of the unit square.
template <class Draw>
void expect_independent(const char* what, Draw draw) {
    constexpr std::size_t side = 17;
    std::array<std::uint64_t, side * side> counts{};
    for (std::uint64_t i = 0; i < draws; ++i) {
        const auto [a, b] = draw(i);
        ++counts[static_cast<std::size_t>(a * side) * side + static_cast<std::size_t>(b * side)];
    }
    const std::vector<double> expected(counts.size(), static_cast<double>(draws) / counts.size());
    EXPECT_GT(chi_square_tail(chi_square(counts, expected), counts.size() - 1), 1e-5) << what;
}

TEST(Random, StreamsAreIndependent) {
    using enum RandomPurpose;
    constexpr auto high = std::uint64_t{1} << 32;
    expect_independent("purposes", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, emission_origin)[1],
                         random_uniforms(1, i, 0, emission_direction)[1]);
    });
    expect_independent("emission and first event", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, emission_direction)[0],
                         random_uniforms(1, i, 0, scattering)[0]);
    });
    expect_independent("events", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, scattering)[0], random_uniforms(1, i, 1, scattering)[0]);
    });
    expect_independent("photons", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, scattering)[0],
                         random_uniforms(1, i + 1, 0, scattering)[0]);
    });
    expect_independent("photons 2^32 apart", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, scattering)[0],
                         random_uniforms(1, i + high, 0, scattering)[0]);
    });
    expect_independent("seeds", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, scattering)[0], random_uniforms(2, i, 0, scattering)[0]);
    });
    expect_independent("seeds 2^32 apart", [](std::uint64_t i) {
        return std::pair(random_uniforms(1, i, 0, scattering)[0],
                         random_uniforms(1 + high, i, 0, scattering)[0]);
    });
    expect_independent("lanes", [](std::uint64_t i) {
        const auto u = random_uniforms(1, i, 0, scattering);
        return std::pair(u[0], u[1]);
    });
    expect_independent("lanes 2 and 3", [](std::uint64_t i) {
        const auto u = random_uniforms(1, i, 0, scattering);
        return std::pair(u[2], u[3]);
    });
}

}  // namespace
