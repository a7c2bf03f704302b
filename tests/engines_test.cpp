// The photon map's engines side by side: exact ones find the same photons, so that their maps answer alike.
#include <gtest/gtest.h>

#include <map>

#include "bench/app/methods.h"
#include "bench/compare/query_points.h"
#include "common/tracer/trace_photons.h"
#include "tests/statistics.h"

namespace {

using namespace tests;

/// Irradiance at the points that the camera sees.
std::vector<common::Rgb> answers(const std::string& method, const bench::LoadedScene& scene,
                                 const bench::QueryPoints& queries) {
    bench::PreparedMethods prepared(scene, {});
    const common::PhotonSource source(scene.scene);
    return bench::with_sink(bench::parse_method("", method), prepared, source, [&](auto sink) {
        const auto trace =
            common::trace_photons(scene.rays, source, 1, {.hits = count_for(200'000, 20'000)}, sink);
        const auto map = common::finish_map(std::move(sink), trace);
        std::vector<common::Rgb> found;
        for (const common::SurfacePoint& point : queries.image_order) found.push_back(map.irradiance(point));
        return found;
    });
}

TEST(Engines, AnswerAlike) {
    const bench::LoadedScene scene(SHLMBENCH_BINARY_DIR "/scenes/cornell.glb", {});
    const bench::QueryPoints queries = bench::visible_query_points(scene, 1);
    // How many photons an answer sums, at most: generous, but for k far below what one photon is worth.
    const std::map<std::string, double> photons = {
        {"k50/disc", 50}, {"r0.01/cone", 5'000}, {"r0.1/disc", 200'000}};
    for (const auto& [selection, most] : photons) {
        const auto expected = answers("photonmap/flann/" + selection, scene, queries);
        for (const std::string engine : {"nanoflann", "grid"}) {
            if (engine == "grid" && selection.starts_with("k")) continue;
            const auto found = answers("photonmap/" + engine + "/" + selection, scene, queries);
            ASSERT_EQ(found.size(), expected.size());
            // The same photons, summed in another order: each addition rounds by 2^-24 at most.
            const double rounding = most * 0x1p-23;
            for (std::size_t i = 0; i < found.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[i][c], expected[i][c], rounding * expected[i][c])
                        << engine << "/" << selection << ", query " << i;
        }
    }
}

}  // namespace
