// Tests the estimate of the noise of a hit from a map's blocks, on surfaces of known noise.
#include "shlm/adaptive/block_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "shlm/layout/prepared_texels.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;

/// Randomly distributed hits; a whole texel at (x, y) has `hits_of(x, y)` of them on average. Every other hit
/// has `dim` times the flux of the rest.
struct Light {
    float width;  ///< width of a floor whose depth is 1
    std::size_t texels;
    double dim;
    std::function<double(float, float)> hits_of;
};

/// Returns the relative variance of one hit's flux, plus one for the variance of their number.
double true_noise(double dim) {
    return 2 * (1 + dim * dim) / ((1 + dim) * (1 + dim));
}

std::vector<double> areas_of(const shlm::PreparedTexels& texels) {
    std::vector<double> areas;
    for (const shlm::TexelGeometry& texel : texels.geometry) areas.push_back(texel.area);
    return areas;
}

double estimated_noise(const Light& light) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {light.width, 0, 0}, {0, 1, 0}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    const shlm::PreparedTexels texels(scene, shlm::find_lightmap_uv(scene), light.texels,
                                      shlm::TexelPlacement::face);
    const std::vector<double> areas = areas_of(texels);
    const double whole = *std::ranges::max_element(areas);
    shlm::TexelSums<shlm::AdaptiveModel> sums(texels.geometry.size(), shlm::Quantum(Rgb(1, 1, 1) * 1e-3f));
    std::mt19937 engine(1);
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i) {
        const auto& centre = texels.geometry[i].center;
        const double hits = light.hits_of(centre.x, centre.y) * areas[i] / whole;
        for (int n = std::poisson_distribution(hits)(engine); n > 0; --n) {
            const auto flux = static_cast<float>(engine() % 2 ? 1 : light.dim);
            sums.add(i, {0, 0, 1}, 1, Rgb(1, 1, 1) * flux);
        }
    }
    return shlm::light_statistics(shlm::light_pyramids(sums, texels, 1)).noise_of_a_hit;
}

double eight(float /*x*/, float /*y*/) {
    return 8;
}

// There are 16,384 blocks of 32 hits. The lower quartile of chi-squared with three degrees of freedom then
// has a relative standard deviation of 1.2 %. Counts are integers, and their tail matches chi-squared's to
// some 4 %.
const double doubt = 0.04 + 0.012 * z_for(1e-6);

TEST(LightStatistics, NoiseOfAHitIsFound) {
    for (const double dim : {1.0, 0.2, 0.0})
        EXPECT_NEAR(estimated_noise({1, 65536, dim, eight}) / true_noise(dim), 1, doubt) << dim;
}

/// Every other block of a strip three texels wide has two parts.
TEST(LightStatistics, BlocksAtTheEdgesOfRegionsDoNotCountForMore) {
    EXPECT_NEAR(estimated_noise({3.0f / 16384, 3 * 16384, 0.2, eight}) / true_noise(0.2), 1, 2 * doubt);
}

/// The light changes between full strength and a tenth after about every five rows of blocks.
TEST(LightStatistics, EdgesOfLightAreHardlyTakenForNoise) {
    const auto striped = [](float /*x*/, float y) {
        return static_cast<int>(y * 256) % 19 < 10 ? 16.0 : 1.6;
    };
    EXPECT_LT(estimated_noise({1, 65536, 0.2, striped}) / true_noise(0.2), 1.4);
}

}  // namespace
