#include <gtest/gtest.h>

#include "common/core/input_error.h"
#include "common/core/threads.h"
#include "photonmap/index/nanoflann_index.h"
#include "tests/support/point_sets.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::Vec3;
using photonmap::NanoflannIndex;

constexpr std::size_t point_count = 3000;
constexpr int query_count = static_cast<int>(count_for(2000, 200));

TEST(NanoflannIndex, FindsExactlyTheNearest) {
    for (const auto& [name, points] : hard_point_sets(point_count, 1)) {
        SCOPED_TRACE(name);
        expect_exact_sets(NanoflannIndex(points), points, 0.3f, 2, query_count);
    }
}

TEST(NanoflannIndex, TakesAnyNumberOfPoints) {
    for (const std::size_t count : {0, 1, 2, 49, 50, 51})
        for (const auto& [name, points] : hard_point_sets(count, 3)) {
            SCOPED_TRACE(testing::Message() << count << " points: " << name);
            expect_exact_sets(NanoflannIndex(points), points, 0.3f, 4, query_count / 20);
        }
}

TEST(NanoflannIndex, IsTheSameForAnyNumberOfThreads) {
    const auto points = hard_point_sets(point_count, 5).at("the faces of a box, a tenth of them twice");
    for (const int threads : {1, 2, 5}) {
        common::ThreadPool pool(threads);
        pool.run([&] { expect_exact_sets(NanoflannIndex(points), points, 0.3f, 6, query_count / 10); });
    }
}

TEST(NanoflannIndex, LeavesOutWhatLiesOnTheRadius) {
    const std::vector<Vec3> points = {{0.5f, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}};
    const NanoflannIndex index(points);
    EXPECT_EQ(found_nearest(index, {0, 0, 0}, 10, 1, common::accept_all).size(), 1u) << "strictly inside";
    EXPECT_EQ(found_nearest(index, {0, 0, 0}, 10, 1.0001f, common::accept_all).size(), 3u);
    EXPECT_TRUE(found_nearest(index, {0, 0, 0}, 10, 0, common::accept_all).empty());
}

TEST(NanoflannIndex, RefusesWhatItsIndicesCannotCount) {
    const Vec3 point(0, 0, 0);
    const std::span<const Vec3> too_many(&point, std::size_t{1} << 32);  // refused before any point is read
    EXPECT_THROW(NanoflannIndex{too_many}, common::InputError);
}

TEST(NanoflannIndex, CountsItsMemory) {
    const auto points = hard_point_sets(100'000, 7).at("one plane");
    const double bytes_a_point =
        static_cast<double>(NanoflannIndex(points).bytes()) / static_cast<double>(points.size());
    EXPECT_GT(bytes_a_point, sizeof(std::uint32_t));
    EXPECT_LT(bytes_a_point, 12) << "what the need for memory is computed with";
}

}  // namespace
