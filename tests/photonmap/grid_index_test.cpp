#include "photonmap/index/grid_index.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

#include "common/core/input_error.h"
#include "common/core/threads.h"
#include "tests/support/point_sets.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::Vec3;
using photonmap::GridCells;
using photonmap::GridIndex;

constexpr std::size_t point_count = 3000;
constexpr int query_count = static_cast<int>(count_for(1000, 100));

std::vector<Vec3> in_order(const std::vector<Vec3>& points, const GridCells& cells) {
    std::vector<Vec3> sorted;
    for (const std::uint32_t i : cells.order(points)) sorted.push_back(points[i]);
    return sorted;
}

/// Radii that are zero or tiny, about right, larger than the scene, and infinite.
constexpr std::array radii = {0.0f, 1e-30f, 1e-6f, 0.02f, 0.3f, 5.0f, 1e9f, no_limit};

TEST(GridIndex, FindsExactlyWhatBruteForceFinds) {
    for (const auto& [name, unsorted] : hard_point_sets(point_count, 1))
        for (const float radius : radii) {
            SCOPED_TRACE(testing::Message() << name << ", cells for " << radius);
            const GridCells cells(unsorted, radius);
            const auto points = in_order(unsorted, cells);
            // Queries have the radius that the index was made for, and an unrelated one.
            for (const float asked : {std::clamp(radius, 1e-6f, 5.0f), 0.1f})
                expect_exact_sets(GridIndex(points, cells), points, asked, 2, query_count / 10);
        }
}

TEST(GridIndex, TakesAnyNumberOfPoints) {
    for (const std::size_t count : {0, 1, 2, 49, 50, 51})
        for (const auto& [name, unsorted] : hard_point_sets(count, 3)) {
            SCOPED_TRACE(testing::Message() << count << " points: " << name);
            const GridCells cells(unsorted, 0.3f);
            const auto points = in_order(unsorted, cells);
            expect_exact_sets(GridIndex(points, cells), points, 0.3f, 4, query_count / 10);
        }
}

TEST(GridIndex, ItsMemoryStaysBounded) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{10}, point_count})
        for (const auto& [name, unsorted] : hard_point_sets(count, 5))
            for (const float radius : radii) {
                const GridCells cells(unsorted, radius);
                EXPECT_LE(cells.count(), 2 * count) << name << ", cells for " << radius;
                const auto points = in_order(unsorted, cells);
                EXPECT_LE(GridIndex(points, cells).bytes(), 8 * count + 4) << name;
            }
}

TEST(GridIndex, ABallMeetsFewCellsOfItsRadius) {
    const auto points = hard_point_sets(point_count, 6).at("one plane");
    constexpr float radius = 0.1f;
    const GridCells cells(points, radius);
    for (const Vec3& p : points) {
        const std::size_t first = cells.along(0, double{p.x} - radius),
                          last = cells.along(0, double{p.x} + radius);
        ASSERT_LE(last - first, 2u);
    }
    EXPECT_GT(cells.count(), 300u) << "20 x 20 cells";
}

TEST(GridCells, TheOrderDoesNotDependOnTheThreads) {
    const auto points = hard_point_sets(point_count, 7).at("the faces of a box, a tenth of them twice");
    const GridCells cells(points, 0.1f);
    const auto expected = cells.order(points);
    for (const int threads : {1, 2, 7}) {
        common::ThreadPool pool(threads);
        pool.run([&] { EXPECT_EQ(cells.order(points), expected); });
    }
    // Every point must occur once, cell by cell, in its old order within a cell.
    std::vector<std::uint32_t> every = expected;
    std::sort(every.begin(), every.end());
    for (std::uint32_t i = 0; i < every.size(); ++i) ASSERT_EQ(every[i], i);
    for (std::size_t i = 1; i < expected.size(); ++i) {
        const auto place = [&](std::size_t j) {
            return std::pair(cells.of(points[expected[j]]), expected[j]);
        };
        ASSERT_LT(place(i - 1), place(i));
    }
}

TEST(GridIndex, RefusesPointsInAnotherOrder) {
    const auto points = hard_point_sets(point_count, 8).at("one line");
    EXPECT_THROW(GridIndex(points, GridCells(points, 0.01f)), std::logic_error);
}

TEST(GridIndex, RefusesWhatItsIndicesCannotCount) {
    const Vec3 point(0, 0, 0);
    const std::span<const Vec3> too_many(&point, std::size_t{1} << 32);  // refused before any point is read
    EXPECT_THROW(GridCells(too_many, 1), common::InputError);
    EXPECT_THROW(GridIndex(too_many, GridCells({}, 1)), common::InputError);
}

/// 2^31 points at one position, which map the same 12 MiB of memory repeatedly, followed by three points at
/// another position.
class ManyPoints {
  public:
    static constexpr std::size_t coincident = std::size_t{1} << 31, count = coincident + 3;

    ManyPoints() {
        constexpr std::size_t chunk = 12 << 20, rest = 4096, all = coincident * sizeof(Vec3);
        const int file = memfd_create("points", 0);
        void* const room = mmap(nullptr, all + rest, PROT_READ | PROT_WRITE,
                                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (file < 0 || ftruncate(file, chunk) != 0 || room == MAP_FAILED) return;
        data_ = static_cast<char*>(room);
        size_ = all + rest;
        for (std::size_t at = 0; at < all; at += chunk)
            ok_ = mmap(data_ + at, chunk, PROT_READ, MAP_SHARED | MAP_FIXED, file, 0) != MAP_FAILED;
        close(file);
        for (std::size_t i = coincident; i < count; ++i) reinterpret_cast<Vec3*>(data_)[i] = Vec3(1, 1, 1);
    }
    ~ManyPoints() {
        if (data_) munmap(data_, size_);
    }

    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] std::span<const Vec3> points() const { return {reinterpret_cast<Vec3*>(data_), count}; }

  private:
    char* data_ = nullptr;
    std::size_t size_ = 0;
    bool ok_ = false;
};

TEST(GridIndex, CountsPastTwoToThe31) {
    if (count_for(1, 0) == 0) GTEST_SKIP() << "minutes in this build";
    const ManyPoints many;
    if (!many.ok()) GTEST_SKIP() << "no address space for 2^31 points";
    const GridIndex index(many.points(), GridCells(many.points(), 0.5f));
    const auto found = found_within(index, {1, 1, 1}, 0.25f, common::accept_all);
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found[i].index, ManyPoints::coincident + i);
}

}  // namespace
