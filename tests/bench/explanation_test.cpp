// The widths of the blocks that the picture of a fit's explanation shows.
#include "bench/experiments/fit/explanation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace bench;
using namespace bench::fit;

constexpr double texels = 16384, hits_per_texel = 4;

class Explanation : public testing::Test {
  protected:
    /// The median over the picture, of a map with few hits to a texel.
    float median_width(CandidateKind kind) {
        FitResult result;
        result.candidates = {{kind, "L0/normalised", "bilinear/face", texels}};
        result.samples.resize(1);  // not measured: no errors of surfaces
        result.light_map.proposal.hits = hits_per_texel * texels;
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

TEST_F(Explanation, ShowsTheBlocksThatShareLight) {
    // Blocks are 1, 2, 4, ... texels wide and have fewer than 100 hits: four texels at the mean density,
    // eight below 0.39 of it, two beyond 1.56 of it.
    const float ratio = median_width(CandidateKind::sharing_map) / median_width(CandidateKind::light_map);
    EXPECT_GE(ratio, 1.9f);
    EXPECT_LE(ratio, 8.1f);
}

}  // namespace
