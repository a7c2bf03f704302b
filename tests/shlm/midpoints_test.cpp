// Tests interpolation between texels against its closed forms: squared bias and variance on smooth light.
#include "shlm/map/midpoints.h"

#include <gtest/gtest.h>

#include "shlm/map/light_map.h"
#include "tests/support/scene_builder.h"
#include "tests/support/texels.h"

namespace {

using namespace tests;
using shlm::Gather;

using Model = shlm::TexelModel<0, shlm::ShWeight::normalised>;
using LightMap = shlm::HarmonicMap<Model>;

/// A floor of side x side texels, from (0, 0) to (1, 1); u and v of its lightmap are x and y.
struct Floor {
    Scene scene;
    shlm::PreparedTexels texels;
    int side;

    explicit Floor(int texels_a_side)
        : scene(made()),
          texels(texels_of(
              scene, static_cast<std::size_t>(texels_a_side) * static_cast<std::size_t>(texels_a_side))),
          side(texels_a_side) {}

    /// Returns a map whose texels hold the means of a function, given by its integral over [0, s] x [0, t].
    template <class Integral>
    [[nodiscard]] LightMap map(const Gather& gather, Integral integral) const {
        shlm::TexelSums<Model> sums(texels.layout.texel_count(), shlm::Quantum(Rgb(1, 1, 1) * 0x1p-20f));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double a = double(x) / side, b = double(x + 1) / side, c = double(y) / side,
                             d = double(y + 1) / side;
                const double light = integral(b, d) - integral(a, d) - integral(b, c) + integral(a, c);
                sums.add(static_cast<std::size_t>(y * side + x), Vec3(0, 0, 1), 1,
                         Rgb(1, 1, 1) * static_cast<float>(light));
            }
        return {sums, texels, 1, gather, 0};
    }

    [[nodiscard]] double at(const LightMap& map, double s, double t) const {
        return double{
            map.irradiance(front_of(scene, on_quad(0, static_cast<float>(s), static_cast<float>(t)))).x};
    }

  private:
    static Scene made() {
        Scene scene;
        add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
        return scene;
    }
};

/// Returns the mean over a texel in the middle of (answer - truth)^2.
template <class Truth>
double mean_squared_bias(const Floor& floor, const LightMap& map, Truth truth) {
    constexpr int steps = 40;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double s = (floor.side / 2 + (i + 0.5) / steps) / floor.side,
                         t = (floor.side / 2 + (j + 0.5) / steps) / floor.side;
            sum += std::pow(floor.at(map, s, t) - truth(s, t), 2);
        }
    return sum / (steps * steps);
}

/// f = 1 + p x^2 + q y^2, whose second derivatives are 2 p and 2 q, and its integral.
constexpr double p = 3, q = 1;
double paraboloid(double x, double y) {
    return 1 + p * x * x + q * y * y;
}
double integral(double x, double y) {
    return x * y + p * x * x * x * y / 3 + q * x * y * y * y / 3;
}

/// In units of h^4, h a texel's width (Scott, "Frequency polygons", 1985, in two dimensions).
TEST(Interpolation, HasTheSquaredBiasOfItsClosedForm) {
    constexpr int side = 8;
    const Floor floor(side);
    const double h4 = std::pow(1.0 / side, 4), fxx = 2 * p, fyy = 2 * q;
    const auto bias_sq = [&](const Gather& gather) {
        return mean_squared_bias(floor, floor.map(gather, integral), paraboloid) / h4;
    };
    // Means: the bias is (1/24 + u (1 - u) / 2) h^2 fxx along an axis, at a distance u h from a middle; its
    // mean is 1/8 h^2 fxx. Midpoints: without the 1/24.
    const double of_means = 49.0 / 2880 * (fxx * fxx + fyy * fyy) + fxx * fyy / 32;
    const double of_midpoints = (fxx * fxx + fyy * fyy) / 120 + fxx * fyy / 72;
    EXPECT_NEAR(bias_sq(shlm::Bilinear{}), of_means, 0.01 * of_means);
    EXPECT_NEAR(bias_sq(shlm::Bilinear{true}), of_midpoints, 0.01 * of_midpoints);
    EXPECT_LT(bias_sq(shlm::Cubic{}), 1e-3 * of_midpoints) << "a cubic is exact for parabolas";
    // A twelfth in place of the 24th would give the midpoints' bias another sign of that 1/24.
    const double of_a_twelfth = (1.0 / 120 - 2 * 1.0 / 24 / 12 + 1.0 / 576) * (fxx * fxx + fyy * fyy) +
                                fxx * fyy * std::pow(1.0 / 12 - 1.0 / 24, 2) * 2;
    EXPECT_GT(std::abs(of_a_twelfth - of_midpoints), 0.1 * of_midpoints) << "the bounds would find it";
}

/// Halving the texels divides the squared bias of waves by 2^4 with bilinear gathers, and by 2^6 with the
/// cubic one, which reproduces parabolas.
TEST(Interpolation, FallsWithItsPowerOfTheWidth) {
    const auto wave = [](double x, double y) { return 2 + std::sin(9 * x + 0.3) * std::sin(7 * y + 0.2); };
    const auto integral_of_wave = [](double x, double y) {
        return 2 * x * y + std::cos(9 * x + 0.3) * std::cos(7 * y + 0.2) / 63;
    };
    const auto power = [&](const Gather& gather) {
        const Floor coarse(32), fine(64);
        return std::log2(mean_squared_bias(coarse, coarse.map(gather, integral_of_wave), wave) /
                         mean_squared_bias(fine, fine.map(gather, integral_of_wave), wave));
    };
    EXPECT_NEAR(power(shlm::Bilinear{}), 4, 0.5);
    EXPECT_NEAR(power(shlm::Bilinear{true}), 4, 0.5);
    EXPECT_GT(power(shlm::Cubic{}), 5.5);
}

/// Of independent noise of variance 1 in each texel: the mean over a texel of the sum of squared weights. A
/// single texel's light, 1, shows its own weight everywhere.
TEST(Interpolation, HasTheVarianceOfItsClosedForm) {
    constexpr int side = 16, steps = 16;
    const Floor floor(side);
    const auto variance = [&](const Gather& gather) {
        // One bright texel on a floor that is bright enough for no weight to be cut off.
        const LightMap map = floor.map(gather, [&](double x, double y) {
            const double middle = 0.5, h = 1.0 / side;
            return 10 * x * y + std::clamp(x - middle, 0.0, h) * std::clamp(y - middle, 0.0, h);
        });
        double sum = 0;
        for (int i = 0; i < side * steps; ++i)
            for (int j = 0; j < side * steps; ++j)
                sum +=
                    std::pow(floor.at(map, (i + 0.5) / (side * steps), (j + 0.5) / (side * steps)) - 10, 2);
        return sum / (steps * steps);
    };
    EXPECT_NEAR(variance(shlm::OwnTexel{}), 1, 1e-3);
    EXPECT_NEAR(variance(shlm::Bilinear{}), 4.0 / 9, 2e-3);
    // The integral of the sum of squared weights along an axis.
    double along = 0;
    for (int i = 0; i < 1000; ++i) {
        const double t = (i + 0.5) / 1000;
        const double w[] = {((-0.5 * t + 1) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1,
                            ((-1.5 * t + 2) * t + 0.5) * t, (0.5 * t - 0.5) * t * t};
        for (const double weight : w) along += weight * weight / 1000;
    }
    EXPECT_GT(variance(shlm::Cubic{}), along * along) << "the correction adds noise";
    EXPECT_LT(variance(shlm::Cubic{}), 1.5 * along * along);
    EXPECT_LT(variance(shlm::Bilinear{true}), 1.5 * 4.0 / 9);
}

/// Nothing is corrected across a chart's border or beside a texel that nothing covers.
TEST(Midpoints, LeaveConstantLightAsItIs) {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    const shlm::PreparedTexels texels = texels_of(scene, 500);
    std::vector<std::array<Rgb, 1>> means(texels.geometry.size(), {Rgb(1, 2, 3)});
    for (std::size_t i = 0; i < means.size(); ++i)
        if (texels.geometry[i].area == 0) means[i][0] = Rgb(0, 0, 0);
    EXPECT_EQ(shlm::midpoints(texels, means), means);
}

}  // namespace
