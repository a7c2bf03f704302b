// Tests the widths of the blocks in the picture of a fit's explanation.
#include "bench/experiments/fit/explanation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace bench;
using namespace bench::fit;

class Explanation : public testing::Test {
  protected:
    /// Returns the median over the picture of a map that was not measured.
    float median_width(double texels) {
        FitResult result;
        result.candidates = {{CandidateKind::light_map, "L0/normalised", "bilinear/face", texels}};
        result.samples.resize(1);
        result.light_map.choice.proposal.hits = 1e5;
        const fit::Explanation explanation =
            explain(result, {loaded, source, prepared, points, 1, std::size_t{1} << 30});
        EXPECT_TRUE(explanation.surfaces.empty());
        std::vector<float> width;
        for (const auto& seen : explanation.pixel)
            if (seen) width.push_back(seen->width);
        const auto middle = width.begin() + std::ssize(width) / 2;
        std::nth_element(width.begin(), middle, width.end());
        return *middle;
    }

    LoadedScene loaded{SHLMBENCH_BINARY_DIR "/scenes/cornell.glb", {}};
    common::PhotonSource source{loaded.scene};
    PreparedScene prepared{loaded, {}};
    FitPoints points = find_fit_points(loaded);
};

TEST_F(Explanation, ShowsTexelsThatCoverTheScene) {
    double area = 0;
    for (std::uint32_t t = 0; t < loaded.scene.triangle.size(); ++t)
        area += common::triangle_area(loaded.scene, t);
    const float width = median_width(16384);
    EXPECT_NEAR(width, std::sqrt(area / 16384), 0.2 * width);
    EXPECT_NEAR(width / median_width(4096), 0.5, 0.05);
}

}  // namespace
