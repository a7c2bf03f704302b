#include "common/core/stable_array.h"

#include <gtest/gtest.h>

namespace {

using common::StableArray;

TEST(StableArray, KeepsItsElementsWhereTheyAre) {
    StableArray<int> array(10'000'000);
    const std::span<int> first = array.grow(3);
    first[0] = 1;
    first[2] = 3;
    for (int i = 0; i < 100; ++i) array.grow(10'000)[0] = i;
    EXPECT_EQ(array.span().data(), first.data());
    EXPECT_EQ(array.size(), 1'000'003u);
    EXPECT_EQ(array[0], 1);
    EXPECT_EQ(array[1], 0) << "zero until written";
    EXPECT_EQ(array[2], 3);
    EXPECT_EQ(array[3 + 99 * 10'000], 99);
}

TEST(StableArray, KeepsItsElementsWhenMoved) {
    StableArray<int> from(100);
    from.grow(2)[1] = 7;
    const int* address = from.span().data();
    const StableArray<int> to(std::move(from));
    EXPECT_EQ(to.span().data(), address);
    EXPECT_EQ(to.size(), 2u);
    EXPECT_EQ(to[1], 7);
    EXPECT_EQ(from.size(), 0u);  // NOLINT(bugprone-use-after-move): a moved array is empty
    EXPECT_THROW((void)from.grow(1), std::bad_alloc);
}

TEST(StableArray, ThrowsPastItsLargestSize) {
    StableArray<int> array(10);
    (void)array.grow(8);
    EXPECT_THROW((void)array.grow(3), std::bad_alloc);
    EXPECT_EQ(array.size(), 8u) << "unchanged";
    EXPECT_EQ(array.grow(2).size(), 2u);
    EXPECT_THROW((void)array.grow(1), std::bad_alloc);
    EXPECT_THROW((void)array.grow(static_cast<std::size_t>(-1)), std::bad_alloc);
    EXPECT_THROW(StableArray<int>(std::size_t{1} << 60), std::bad_alloc);
}

TEST(StableArray, CountsWholePages) {
    StableArray<double> array(1'000'000);
    EXPECT_EQ(array.bytes(), 0u);
    (void)array.grow(1);
    EXPECT_EQ(array.bytes(), 4096u);
    (void)array.grow(511);
    EXPECT_EQ(array.bytes(), 4096u);
    (void)array.grow(1);
    EXPECT_EQ(array.bytes(), 8192u);
}

}  // namespace
