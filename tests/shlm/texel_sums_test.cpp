#include "shlm/sums/texel_sums.h"

#include <gtest/gtest.h>

#include <random>

#include "bench/contenders/plain_sums.h"
#include "common/core/input_error.h"
#include "common/core/sampling.h"
#include "shlm/map/sink.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::Rgb;
using common::Vec3;
using shlm::PaperModel;
using shlm::Quantum;
using shlm::ShWeight;
using shlm::TexelModel;

struct Hit {
    Vec3 towards_light;
    float inverse_cosine;
    Rgb flux;
};

/// Makes uniform light of photons with equal flux in one channel and random flux in the others.
std::vector<Hit> random_hits(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Hit> hits(count);
    for (Hit& hit : hits) {
        const Vec3 light = common::sample_cosine_hemisphere(uniform(random), uniform(random));
        hit = {light, 1 / std::max(light.z, common::min_incident_cosine),
               Rgb(1, uniform(random), uniform(random) * uniform(random))};
    }
    return hits;
}

const Quantum white(Rgb(1, 1, 1));

template <class SomeSums>
void add_all(SomeSums& sums, std::span<const Hit> hits) {
    for (const Hit& hit : hits) sums.add(0, hit.towards_light, hit.inverse_cosine, hit.flux);
}

/// Returns what the hits add to number k of a texel, computed from the same harmonics.
template <class Model>
double sum_in_doubles(std::span<const Hit> hits, std::size_t k) {
    double sum = 0;
    for (const Hit& hit : hits)
        sum += double{Model::of_hit(hit.towards_light, hit.inverse_cosine)[k / 3]} *
               hit.flux[static_cast<int>(k % 3)];
    return sum;
}

using Sums = shlm::TexelSums<PaperModel>;

bool same(const Sums& a, const Sums& b) {
    for (std::size_t k = 0; k < 3 * PaperModel::summed; ++k)
        if (a.quanta(0, k) != b.quanta(0, k)) return false;
    return a.hits(0) == b.hits(0);
}

void join(Sums& sums, const Sums& piece) {
    for (std::size_t k = 0; k < 3 * PaperModel::summed; ++k) sums.add_quanta(0, k, piece.quanta(0, k));
    sums.add_hits(0, piece.hits(0));
}

/// Calls `work` with an object of each texel model.
template <class Work>
void for_each_model(Work work) {
    const auto with_order = [&]<int Order>(std::integral_constant<int, Order>) {
        work(TexelModel<Order, ShWeight::radiance>{});
        work(TexelModel<Order, ShWeight::flux>{});
        work(TexelModel<Order, ShWeight::normalised>{});
    };
    with_order(std::integral_constant<int, 0>{});
    with_order(std::integral_constant<int, 1>{});
    with_order(std::integral_constant<int, 2>{});
    with_order(std::integral_constant<int, 4>{});
}

TEST(Quantum, IsAPowerOfTwoThatMakesTheLightTwentyFourBits) {
    for (const float watts : {1e-20f, 0.3f, 1.0f, 1.99f, 1234.5f, 3e38f}) {
        const Quantum quantum(Rgb(watts, watts / 8, 0));
        const Rgb light = Rgb(watts, watts / 8, watts) * quantum.per_flux();
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(light[c], 0x1p23f) << watts << " W, channel " << c;
            EXPECT_LT(light[c], 0x1p24f) << watts << " W, channel " << c;
            EXPECT_EQ(quantum.unit(c) * quantum.per_flux()[c], 1);
        }
    }
    const Quantum dark(Rgb(0, 0, 0));
    EXPECT_EQ(dark.unit(0), 0x1p-23);
    const Quantum faintest(Rgb(1e-45f, 0, 0));
    EXPECT_TRUE(common::is_finite(faintest.per_flux()));
}

TEST(TexelModel, KnowsItsLargestNumber) {
    constexpr int steps = 400;
    for_each_model([](auto model) {
        using Model = decltype(model);
        for (const float inverse_cosine : {1.0f, 1.5f, 1000.0f}) {
            float largest = 0;
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; j < steps; ++j)
                    for (const float value :
                         Model::of_hit(common::direction_at(1 - 2.0f * static_cast<float>(i) / steps,
                                                            static_cast<float>(j) / steps),
                                       inverse_cosine))
                        largest = std::max(largest, std::abs(value));
            EXPECT_LT(largest, 0.99f * Model::largest_of_hit(inverse_cosine))
                << "order " << Model::order << ", weight " << static_cast<int>(Model::weight);
            EXPECT_GT(largest, 0.95f * Model::largest_of_hit(inverse_cosine)) << "or it drains too often";
        }
    });
}

/// The largest fluxes exceed what 32 bits hold, the smallest are below a quantum.
std::vector<Hit> hits_of_all_sizes(unsigned seed) {
    std::vector<Hit> hits = random_hits(count_for(200'000, 20'000), seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(-30, 20);
    for (std::size_t i = 0; i < hits.size(); i += 2) hits[i].flux *= std::exp2(exponent(random));
    // They are in the direction of the largest harmonics, so runs of hits all add to the same number.
    for (std::size_t i = 0; i < hits.size() / 4; ++i) hits[i].towards_light = {0, 0, 1};
    return hits;
}

TEST(TexelSums, AreThoseOfPlainIntegersForHitsOfAnySize) {
    constexpr unsigned seed = 1;
    const std::vector<Hit> hits = hits_of_all_sizes(seed);
    for_each_model([&](auto model) {
        using Model = decltype(model);
        shlm::TexelSums<Model> sums(1, white);
        bench::PlainSums<Model, std::int64_t> plain(1, white);
        add_all(sums, hits);
        add_all(plain, hits);
        EXPECT_EQ(sums[0].hits, hits.size());
        for (std::size_t k = 0; k < 3 * Model::summed; ++k)
            ASSERT_EQ(sums[0].value[k], plain.value(0, k))
                << "number " << k << " of order " << Model::order << ", weight "
                << static_cast<int>(Model::weight) << ", seed " << seed;
    });
}

TEST(TexelSums, DoNotDependOnTheOrderOfHitsNorOnHowARunIsCut) {
    constexpr unsigned seed = 2;
    std::vector<Hit> hits = hits_of_all_sizes(seed);
    Sums once(1, white), shuffled(1, white), joined(1, white);
    add_all(once, hits);
    std::mt19937 random(seed);
    std::shuffle(hits.begin(), hits.end(), random);
    add_all(shuffled, hits);
    EXPECT_TRUE(same(shuffled, once));

    for (std::size_t begin = 0, end = 1; begin < hits.size(); begin = end, end = 3 * end + 1) {
        Sums piece(1, white);
        add_all(piece, std::span(hits).subspan(begin, std::min(end, hits.size()) - begin));
        join(joined, piece);
    }
    EXPECT_TRUE(same(joined, once));
}

TEST(TexelSums, HaveTheErrorOfRoundingSingleHits) {
    constexpr unsigned seed = 3;
    const std::vector<Hit> hits = random_hits(count_for(1'000'000, 50'000), seed);
    Sums sums(1, white);
    add_all(sums, hits);
    // A product has an error of half a float's last bit and half a quantum; in the worst case all have the
    // same sign.
    const auto count = static_cast<double>(hits.size());
    const double light = sum_in_doubles<PaperModel>(hits, 0);
    for (std::size_t k = 0; k < sums[0].value.size(); ++k)
        EXPECT_NEAR(sums[0].value[k], sum_in_doubles<PaperModel>(hits, k), 0x1p-24 * (count + 4 * light))
            << "number " << k << ", seed " << seed;
}

TEST(TexelSums, ABillionRandomHitsAreRightToAMillionth) {
    constexpr unsigned seed = 4;
    constexpr int pieces = 1000;  // the same million repeatedly: errors add up without cancelling
    const std::vector<Hit> hits = random_hits(count_for(1'000'000, 50'000), seed);
    Sums piece(1, white), sums(1, white);
    add_all(piece, hits);
    for (int i = 0; i < pieces; ++i) join(sums, piece);
    EXPECT_EQ(sums[0].hits, hits.size() * pieces);
    for (std::size_t k = 0; k < 3; ++k) {
        const double expected = sum_in_doubles<PaperModel>(hits, k) * pieces;
        EXPECT_NEAR(sums[0].value[k], expected, 1e-6 * expected) << "channel " << k << ", seed " << seed;
    }
}

/// Returns the relative error of the first number after `count` equal adds of a whole photon's light.
template <class SomeSums>
double error_of_equal_adds(std::uint64_t count, const Hit& hit) {
    SomeSums sums(1, white);
    for (std::uint64_t i = 0; i < count; ++i) sums.add(0, hit.towards_light, hit.inverse_cosine, hit.flux);
    const double expected = static_cast<double>(count) * sum_in_doubles<PaperModel>(std::span(&hit, 1), 0);
    double value;
    if constexpr (requires { sums.value(0, 0); })
        value = sums.value(0, 0);
    else
        value = sums[0].value[0];
    return std::abs(value - expected) / expected;
}

TEST(TexelSums, EqualAddsDoNotStall) {
    // Equal adds have equal errors, so one add has the relative error of 1e9: more would only repeat it.
    const auto error = [](std::uint64_t count, float inverse_cosine, float flux) {
        return error_of_equal_adds<Sums>(count, {{0, 0.6f, 0.8f}, inverse_cosine, Rgb(flux, 1, 1)});
    };
    EXPECT_LT(error(count_for(3 << 24, 1 << 18), 1.37f, 0.7f), 2.5e-7);
    for (const float flux : {1.0f, 0.7f, 1.9999f})
        for (const float inverse_cosine : {1.0f, 1.37f, 900.0f})
            EXPECT_LT(error(1 << 18, inverse_cosine, flux), 2.5e-7)
                << flux << " W, 1 / cosine " << inverse_cosine;
}

TEST(TexelSums, TheAlternativesAreWorseOrLarger) {
    const Hit hit{{0, 0.6f, 0.8f}, 1.37f, Rgb(0.7f, 1, 1)};
    const std::uint64_t count = count_for(3 << 24, 1 << 18);
    bench::PlainSums<PaperModel, float> floats(1, white);
    floats.add(0, hit.towards_light, hit.inverse_cosine, hit.flux * 0x1p25f);
    const double before = floats.value(0, 0);
    for (int i = 0; i < 1000; ++i) floats.add(0, hit.towards_light, hit.inverse_cosine, hit.flux);
    EXPECT_EQ(floats.value(0, 0), before) << "after 2^25 equal adds it takes no more";
    EXPECT_LT((error_of_equal_adds<bench::FloatsDrainedIntoDoubles<PaperModel>>(count, hit)), 1e-5);
    EXPECT_LT((error_of_equal_adds<bench::PlainSums<PaperModel, double>>(count, hit)), 1e-7);
    using Floats = bench::FloatsDrainedIntoDoubles<PaperModel>;
    std::vector<Hit> hits = random_hits(1000, 5);
    Floats forwards(1, white), backwards(1, white);
    add_all(forwards, hits);
    std::reverse(hits.begin(), hits.end());
    add_all(backwards, hits);
    EXPECT_NE(forwards.value(0, 0), backwards.value(0, 0)) << "the order shows";
}

TEST(TexelSums, ThatWouldLeaveTheirRangeEndTheRun) {
    const Hit brightest{{0, 0, 1}, 1000, Rgb(1, 1, 1)};
    Sums sums(2, white);
    add_all(sums, std::span(&brightest, 1));
    // The sum is doubled until there is no room for another doubling.
    EXPECT_THROW(for (int i = 0; i < 63; ++i) join(sums, sums), common::InputError);
    EXPECT_NO_THROW(sums.add(1, brightest.towards_light, 1, brightest.flux)) << "another texel";
    for (const float flux : {1e30f, std::numeric_limits<float>::max(), -1e30f}) {
        Sums fresh(1, white);
        EXPECT_THROW(fresh.add(0, {0, 0, 1}, 1000, Rgb(flux, 1, 1)), common::InputError) << flux;
    }
    Sums filling(1, white);
    EXPECT_THROW(for (int i = 0; i < 100; ++i) filling.add(0, {0, 0, 1}, 1000, Rgb(0x1p25f, 0, 0)),
                 common::InputError)
        << "one hit after the other";
}

}  // namespace
