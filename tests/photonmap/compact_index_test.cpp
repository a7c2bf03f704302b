#include "photonmap/index/compact_index.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <random>

#include "common/core/threads.h"
#include "photonmap/index/compact_build.h"
#include "photonmap/index/nearest_selection.h"
#include "tests/support/point_sets.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::NearestSet;
using common::Neighbour;
using common::Vec3;
using photonmap::CompactIndex;
using photonmap::NearestSelection;

struct Numbered {
    Vec3 position;
    std::uint32_t number;
};

/// The index, and the number of the point at each of its places.
struct Built {
    CompactIndex index;
    std::vector<std::uint32_t> number_at;
};

constexpr std::uint32_t nobody = 0xffffffff;

Built build(const std::vector<Vec3>& points) {
    common::StableArray<Numbered> records(points.size());
    const auto room = records.grow(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) room[i] = {points[i], i};
    std::vector<std::uint32_t> number_at;
    CompactIndex index = photonmap::build_compact_index(
        std::move(records), [&](std::size_t places) { number_at.assign(places, nobody); },
        [&](std::size_t place, const Numbered& record) { number_at[place] = record.number; });
    return {std::move(index), std::move(number_at)};
}

using Accept = std::function<bool(std::uint32_t)>;
const Accept all = [](std::uint32_t) { return true; };

/// Finds the expected points by sorting all places that are occupied.
std::vector<Neighbour> expected_nearest(const Built& built, const std::vector<Vec3>& points,
                                        const Vec3& query, std::size_t k, float radius_sq,
                                        const Accept& accept) {
    std::vector<Neighbour> found;
    for (std::uint32_t place = 0; place < built.number_at.size(); ++place) {
        if (built.number_at[place] == nobody || !accept(place)) continue;
        const float distance_sq = common::distance_sq(query, points[built.number_at[place]]);
        if (distance_sq < radius_sq) found.push_back({distance_sq, place});
    }
    std::sort(found.begin(), found.end());
    if (found.size() > k) found.resize(k);
    return found;
}

std::vector<Neighbour> as_neighbours(std::span<const NearestSelection::Key> keys) {
    std::vector<Neighbour> found;
    for (const auto key : keys)
        found.push_back({NearestSelection::distance_sq(key), NearestSelection::index(key)});
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<Neighbour> nearest_by_selection(const CompactIndex& index, const Vec3& query, std::size_t k,
                                            float radius_sq, const Accept& accept) {
    std::vector<NearestSelection::Key> room(NearestSelection::room_for(k));
    NearestSelection selection(room, k, radius_sq);
    index.search(query, selection, accept);
    return as_neighbours(selection.finish());
}

std::vector<Neighbour> all_within(const CompactIndex& index, const Vec3& query, float radius_sq,
                                  const Accept& accept) {
    std::vector<Neighbour> found;
    common::AllWithin collector(radius_sq, [&](float distance_sq, std::uint32_t place) {
        found.push_back({distance_sq, place});
    });
    index.search(query, collector, accept);
    std::sort(found.begin(), found.end());
    return found;
}

/// Returns sizes around those of leaves, nodes and the grid's cells.
std::vector<std::size_t> sizes() {
    return {0, 1, 2, 31, 32, 33, 49, 50, 51, 64, 65, 511, 512, 513, 5000, count_for(70'000, 17'000)};
}

void expect_exact(const std::vector<Vec3>& points, unsigned seed, int queries) {
    const Built built = build(points);
    ASSERT_EQ(built.index.size(), points.size());
    std::vector<int> times(points.size(), 0);
    for (std::size_t place = 0; place < built.number_at.size(); ++place)
        if (const std::uint32_t number = built.number_at[place]; number != nobody) {
            ++times[number];
            ASSERT_EQ(built.index.position(place), points[number]);
        }
    ASSERT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(points.size()));

    Imath::Box3f bounds(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    for (const Vec3& point : points) bounds.extendBy(point);
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-0.1f, 1.1f);
    for (int i = 0; i < queries; ++i) {
        Vec3 query = bounds.min + bounds.size() * Vec3(uniform(engine), uniform(engine), uniform(engine));
        if (!points.empty() && engine() % 2) query = points[engine() % points.size()];
        const std::size_t k = std::array<std::size_t, 5>{1, 2, 50, 51, 700}[engine() % 5];
        const float radius = engine() % 2 ? no_limit : bounds.size().length() * std::abs(uniform(engine)) / 4;
        const float radius_sq = radius * radius;
        const std::uint32_t left_out = engine() % 2 ? 3 : nobody;
        const Accept accept = [=](std::uint32_t place) { return place % left_out != 1; };
        const auto expected = expected_nearest(built, points, query, k, radius_sq, accept);
        const auto what = testing::Message() << points.size() << " points, query " << i << ", k " << k
                                             << ", radius " << radius << ", seed " << seed;
        ASSERT_EQ(found_nearest(built.index, query, k, radius_sq, accept), expected) << what;
        ASSERT_EQ(nearest_by_selection(built.index, query, k, radius_sq, accept), expected) << what;
        ASSERT_EQ(all_within(built.index, query, radius_sq, accept),
                  expected_nearest(built, points, query, points.size(), radius_sq, accept))
            << what;
    }
}

template <class MakePoint>
void expect_exact_for_all_sizes(unsigned seed, MakePoint make_point) {
    for (const std::size_t size : sizes()) {
        std::mt19937 engine(seed);
        std::vector<Vec3> points(size);
        for (Vec3& point : points) point = make_point(engine);
        expect_exact(points, seed + 1, size > 10'000 ? 30 : static_cast<int>(count_for(100, 30)));
        if (testing::Test::HasFatalFailure()) return;
    }
}

float uniform(std::mt19937& engine) {
    return std::uniform_real_distribution<float>(-1, 1)(engine);
}

TEST(CompactIndex, IsExactInAVolume) {
    expect_exact_for_all_sizes(1, [](std::mt19937& e) { return Vec3(uniform(e), uniform(e), uniform(e)); });
}

TEST(CompactIndex, IsExactOnWalls) {
    expect_exact_for_all_sizes(2, [](std::mt19937& e) {
        Vec3 p(uniform(e), uniform(e), uniform(e));
        p[static_cast<int>(e() % 3)] = e() % 2 ? 1.0f : -1.0f;
        return p;
    });
}

TEST(CompactIndex, IsExactInOnePlane) {
    expect_exact_for_all_sizes(3, [](std::mt19937& e) { return Vec3(uniform(e), 0.25f, uniform(e)); });
}

TEST(CompactIndex, IsExactOnALine) {
    expect_exact_for_all_sizes(4, [](std::mt19937& e) { return Vec3(3, uniform(e), -2); });
}

TEST(CompactIndex, IsExactForCoincidentPoints) {
    expect_exact_for_all_sizes(5, [](std::mt19937&) { return Vec3(1, 2, 3); });
}

TEST(CompactIndex, IsExactOnACoarseLattice) {
    // Many points coincide, and many have equal distances.
    expect_exact_for_all_sizes(6, [](std::mt19937& e) {
        return Vec3(static_cast<float>(e() % 7), static_cast<float>(e() % 7), static_cast<float>(e() % 2));
    });
}

TEST(CompactIndex, IsExactFarFromTheOrigin) {
    expect_exact_for_all_sizes(7, [](std::mt19937& e) {  // distances lose most of their digits
        return Vec3(1000 + uniform(e), -2000 + uniform(e), 500);
    });
}

TEST(CompactIndex, IsExactWhereDensitiesDifferByALot) {
    expect_exact_for_all_sizes(8, [](std::mt19937& e) {
        const float scale = std::exp2(-static_cast<float>(e() % 40));
        return Vec3(uniform(e), uniform(e), uniform(e)) * scale;
    });
}

TEST(CompactIndex, IsExactForTheSmallestAndLargestCoordinates) {
    expect_exact_for_all_sizes(9, [](std::mt19937& e) {
        const float scale = std::array<float, 4>{1e-38f, 1e-20f, 1, 1e18f}[e() % 4];
        return Vec3(uniform(e), uniform(e), uniform(e)) * scale;
    });
}

bool same_bytes(const CompactIndex& a, const CompactIndex& b) {
    const auto same = [](auto x, auto y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    };
    return same(a.tree().leaves.span(), b.tree().leaves.span()) &&
           same(a.tree().nodes.span(), b.tree().nodes.span());
}

TEST(CompactIndex, IsTheSameForAnyNumberOfThreads) {
    constexpr std::size_t count = count_for(600'000, 300'000);  // several chunks, blocks and levels of cells
    std::mt19937 engine(10);
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = {uniform(engine), std::round(uniform(engine) * 4), uniform(engine)};
    const auto with_threads = [&](int threads) {
        common::ThreadPool pool(threads);
        return pool.run([&] { return build(points); });
    };
    const Built one = with_threads(1);
    for (const int threads : {2, 7}) {
        const Built other = with_threads(threads);
        EXPECT_TRUE(same_bytes(one.index, other.index)) << threads << " threads";
        EXPECT_EQ(one.number_at, other.number_at) << threads << " threads";
    }
}

TEST(CompactIndex, TakesOneAndAHalfBytesAPointBesidePositions) {
    std::mt19937 engine(11);
    std::vector<Vec3> points(300'000);
    for (Vec3& p : points) p = {uniform(engine), 1, uniform(engine)};
    EXPECT_LE(static_cast<double>(build(points).index.bytes()), 13.5 * static_cast<double>(points.size()));
}

TEST(NearestSelection, KeepsTheSmallestOfWhatItIsOffered) {
    constexpr unsigned seed = 12;
    std::mt19937 engine(seed);
    for (int round = 0; round < 3000; ++round) {
        const std::size_t k = 1 + engine() % 60, offered = engine() % (engine() % 2 ? 100 : 2000);
        const bool lattice = engine() % 2;
        const float radius_sq = engine() % 4 ? static_cast<float>(engine() % 25) : no_limit;
        std::vector<NearestSelection::Key> room(NearestSelection::room_for(k));
        NearestSelection selection(room, k, radius_sq);
        std::vector<Neighbour> expected;
        std::vector<std::uint32_t> numbers(offered);
        for (std::uint32_t i = 0; i < offered; ++i) numbers[i] = i;
        std::shuffle(numbers.begin(), numbers.end(), engine);
        for (const std::uint32_t number : numbers) {
            const float distance_sq = lattice ? static_cast<float>(engine() % 20)  // many ties
                                              : std::exp2(30 * uniform(engine));
            if (distance_sq < radius_sq) expected.push_back({distance_sq, number});
            selection.offer(distance_sq, number);
        }
        std::sort(expected.begin(), expected.end());
        if (expected.size() > k) expected.resize(k);
        const bool all_found = expected.size() == k;
        ASSERT_EQ(selection.full(), all_found);
        if (all_found) {
            ASSERT_GE(selection.reach_sq(), expected.back().distance_sq);
        } else {
            ASSERT_EQ(selection.reach_sq(), radius_sq);
        }
        const auto keys = selection.finish();
        if (all_found) {
            ASSERT_EQ(NearestSelection::index(keys.front()), expected.back().index) << "the farthest first";
        }
        ASSERT_EQ(as_neighbours(keys), expected) << "round " << round << ", seed " << seed;
    }
}

}  // namespace
