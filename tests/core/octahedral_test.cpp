// Tests unit vectors in few bits.
#include "common/core/octahedral.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using common::Octahedral;
using common::Vec3;

Vec3 random_direction(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    return Vec3(normal(engine), normal(engine), normal(engine)).normalized();
}

double angle_between(const Vec3& a, const Vec3& b) {
    const Imath::V3d x(a), y(b);
    return std::atan2(x.cross(y).length(), x.dot(y));
}

template <int Bits>
void expect_directions_within_bound(unsigned seed) {
    // Half a step in each coordinate moves a point of the octahedron by at most sqrt(6) half steps. Its faces
    // are as near to the centre as 1 / sqrt(3), so the angle is at most 3 sqrt(2) half steps.
    const double bound = std::sqrt(4.5) / Octahedral<Bits>::half_steps, float_rounding = 1e-6;
    std::mt19937 engine(seed);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        Vec3 direction = random_direction(engine);
        if (engine() % 4 == 0) direction[static_cast<int>(engine() % 3)] *= 1e-4f;  // along an edge
        direction.normalize();
        const Vec3 back = Octahedral<Bits>::unpack(Octahedral<Bits>::pack(direction));
        ASSERT_NEAR(back.length(), 1, 1e-6);
        worst = std::max(worst, angle_between(direction, back));
    }
    EXPECT_LE(worst, bound + float_rounding);
    EXPECT_GE(worst, 0.5 * bound) << "the bound is not a bound of this";
}

TEST(Octahedral, KeepsDirections) {
    expect_directions_within_bound<13>(1);
    expect_directions_within_bound<8>(2);
    expect_directions_within_bound<16>(3);
}

TEST(Octahedral, KeepsAxesExactly) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            Vec3 direction(0, 0, 0);
            direction[axis] = sign;
            EXPECT_EQ(Octahedral<13>::unpack(Octahedral<13>::pack(direction)), direction);
            EXPECT_EQ(Octahedral<8>::unpack(Octahedral<8>::pack(direction)), direction);
            EXPECT_EQ(Octahedral<16>::unpack(Octahedral<16>::pack(direction)), direction);
        }
}

}  // namespace
