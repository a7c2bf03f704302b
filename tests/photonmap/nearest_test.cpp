#include <gtest/gtest.h>

#include <random>

#include "common/point_index/flann_index.h"
#include "common/point_index/point_index.h"
#include "tests/support/point_sets.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::BruteForceIndex;
using common::FlannIncrementalIndex;
using common::FlannIndex;
using common::NearestSet;
using common::Neighbour;
using common::Vec3;

/// Returns points on the faces of a box, where many share a coordinate, as photons do. A tenth coincides with
/// another point.
std::vector<Vec3> points_on_a_box(std::size_t count, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<Vec3> points;
    while (points.size() < count) {
        Vec3 p(uniform(engine), uniform(engine), uniform(engine));
        const auto axis = static_cast<int>(engine() % 3);
        p[axis] = engine() % 2 ? 1.0f : -1.0f;
        if (!points.empty() && engine() % 10 == 0) p = points[engine() % points.size()];
        points.push_back(p);
    }
    return points;
}

/// Returns a query like those of gathers: on the faces, on the points themselves, or anywhere around.
Vec3 random_query(const std::vector<Vec3>& points, std::mt19937& engine) {
    std::uniform_real_distribution<float> uniform(-1.3f, 1.3f);
    Vec3 query(uniform(engine), uniform(engine), uniform(engine));
    if (engine() % 3 == 0) query[static_cast<int>(engine() % 3)] = 1;
    if (engine() % 3 == 0) query = points[engine() % points.size()];
    return query;
}

template <class Index>
void expect_exact(const Index& index, const std::vector<Vec3>& points, unsigned seed, int queries) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < queries; ++i) {
        const Vec3 query = random_query(points, engine);
        const std::size_t k = std::array<std::size_t, 5>{1, 2, 7, 50, 200}[engine() % 5];
        const float radius = engine() % 2 ? no_limit : 0.7f * uniform(engine);
        const std::uint32_t left_out =
            engine() % 2 ? 3 : 1'000'000'000;  // every third point, or none but the first
        const auto accept = [&](std::uint32_t p) { return p % left_out != 0; };
        ASSERT_EQ(found_nearest(index, query, k, radius * radius, accept),
                  sorted_nearest(points, query, k, radius * radius, accept))
            << "query " << i << ", k " << k << ", radius " << radius << ", seed " << seed;
    }
}

constexpr std::size_t point_count = 4000;
constexpr int query_count = static_cast<int>(count_for(10'000, 1'000));

TEST(FlannIndex, FindsExactlyTheNearest) {
    const auto points = points_on_a_box(point_count, 1);
    expect_exact(FlannIndex(points), points, 2, query_count);
}

TEST(FlannIndex, FindsExactlyTheNearestFarFromTheOrigin) {
    auto points = points_on_a_box(point_count, 3);
    for (Vec3& p : points) p += Vec3(1000, -2000, 500);  // distances lose most of their digits
    expect_exact(FlannIndex(points), points, 4, query_count / 5);
}

TEST(BruteForceIndex, FindsExactlyTheNearest) {
    const auto points = points_on_a_box(point_count, 5);
    expect_exact(BruteForceIndex(points), points, 6, query_count / 5);
}

TEST(FlannIndex, TakesAnyNumberOfPoints) {
    for (const std::size_t count : {0, 1, 2, 49, 50, 51}) {
        const auto points = points_on_a_box(count, 7);
        const FlannIndex index(points);
        EXPECT_EQ(found_nearest(index, {0, 0, 0}, 50, no_limit, common::accept_all),
                  sorted_nearest(points, {0, 0, 0}, 50, no_limit, common::accept_all))
            << count << " points";
    }
}

TEST(FlannIndex, RejectedPointsTakeNobodysPlace) {
    const std::vector<Vec3> points = {{0.1f, 0, 0}, {0.2f, 0, 0}, {0.3f, 0, 0}, {0.4f, 0, 0}};
    const auto found =
        found_nearest(FlannIndex(points), {0, 0, 0}, 2, no_limit, [](std::uint32_t i) { return i >= 2; });
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].index, 2u);
    EXPECT_EQ(found[1].index, 3u);
    EXPECT_TRUE(found_nearest(FlannIndex(points), {0, 0, 0}, 2, no_limit, [](std::uint32_t) {
                    return false;
                }).empty());
}

TEST(FlannIndex, TakesCoincidentPointsInTheirOrder) {
    const std::vector<Vec3> points(5000, Vec3(1, 2, 3));
    const FlannIndex index(points);
    for (const Vec3& query : {Vec3(1, 2, 3), Vec3(0, 0, 0)}) {
        const auto found = found_nearest(index, query, 10, no_limit, common::accept_all);
        ASSERT_EQ(found.size(), 10u);
        for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(found[i].index, i);
    }
}

TEST(FlannIndex, LeavesOutWhatLiesOnTheRadius) {
    const std::vector<Vec3> points = {{0.5f, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}};
    const FlannIndex index(points);
    EXPECT_EQ(found_nearest(index, {0, 0, 0}, 10, 1, common::accept_all).size(), 1u) << "strictly inside";
    EXPECT_EQ(found_nearest(index, {0, 0, 0}, 10, 1.0001f, common::accept_all).size(), 3u);
    EXPECT_TRUE(found_nearest(index, {0, 0, 0}, 10, 0, common::accept_all).empty());
}

TEST(FlannIndex, CountsItsMemory) {
    const auto small = points_on_a_box(1000, 8), large = points_on_a_box(100'000, 9);
    EXPECT_GT(FlannIndex(small).bytes(), small.size() * sizeof(Vec3));
    EXPECT_GT(FlannIndex(large).bytes(), 20 * FlannIndex(small).bytes());
}

TEST(FlannIncrementalIndex, FindsNearlyAll) {
    const auto points = points_on_a_box(count_for(20'000, 5'000), 10);
    FlannIncrementalIndex index;
    index.add({});
    std::mt19937 engine(11);
    for (std::size_t done = 0; done < points.size();) {
        const std::size_t some = std::min<std::size_t>(1 + engine() % 1000, points.size() - done);
        index.add(std::span(points).subspan(done, some));
        done += some;
    }
    std::size_t found = 0, wanted = 0;
    // Queries are on the surfaces that contain the points, like those of gathers; elsewhere the search finds
    // fewer.
    const auto queries = points_on_a_box(query_count / 10, 14);
    for (const Vec3& query : queries) {
        const auto expected = sorted_nearest(points, query, 50, no_limit, common::accept_all);
        const auto actual = found_nearest(index, query, 50, no_limit, common::accept_all);
        ASSERT_EQ(actual.size(), 50u);
        wanted += 50;
        for (const Neighbour& neighbour : actual)
            found += std::binary_search(expected.begin(), expected.end(), neighbour);
    }
    EXPECT_GE(static_cast<double>(found), 0.98 * static_cast<double>(wanted));
}

TEST(FlannIncrementalIndex, TakesAnyNumberOfPoints) {
    const FlannIncrementalIndex empty;
    EXPECT_TRUE(found_nearest(empty, {0, 0, 0}, 5, no_limit, common::accept_all).empty());
    const auto points = points_on_a_box(6, 12);
    FlannIncrementalIndex index;
    for (std::size_t i = 0; i < points.size(); ++i) {
        index.add(std::span(points).subspan(i, 1));
        EXPECT_EQ(found_nearest(index, {0, 0, 0}, 5, no_limit, common::accept_all).size(),
                  std::min<std::size_t>(i + 1, 5));
    }
}

TEST(FlannIncrementalIndex, SurvivesCoincidentPoints) {
    const std::vector<Vec3> points(1000, Vec3(1, 2, 3));
    FlannIncrementalIndex index;
    for (std::size_t i = 0; i < points.size(); i += 100) index.add(std::span(points).subspan(i, 100));
    EXPECT_EQ(found_nearest(index, {0, 0, 0}, 50, no_limit, common::accept_all).size(), 50u);
}

TEST(NearestSet, KeepsTheSmallestOfWhatItIsOffered) {
    constexpr unsigned seed = 13;
    std::mt19937 engine(seed);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t offered = engine() % 100, k = 1 + engine() % 40;
        std::vector<Neighbour> all;
        for (std::uint32_t i = 0; i < offered; ++i)
            all.push_back({static_cast<float>(engine() % 20), i});  // many ties
        std::shuffle(all.begin(), all.end(), engine);
        const auto radius_sq = static_cast<float>(engine() % 25);
        std::vector<Neighbour> storage(k);
        NearestSet set(storage, radius_sq);
        for (const Neighbour& n : all) set.offer(n.distance_sq, n.index);

        std::erase_if(all, [&](const Neighbour& n) { return n.distance_sq >= radius_sq; });
        std::sort(all.begin(), all.end());
        if (all.size() > k) all.resize(k);
        ASSERT_EQ(set.full(), all.size() == k);
        ASSERT_EQ(set.reach_sq(), all.size() == k ? all.back().distance_sq : radius_sq);
        if (set.full()) {
            ASSERT_EQ(set.found().front(), all.back()) << "the farthest comes first";
        }
        std::vector<Neighbour> found(set.found().begin(), set.found().end());
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, all) << "round " << round << ", seed " << seed;
    }
}

}  // namespace
