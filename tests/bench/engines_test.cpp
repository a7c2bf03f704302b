// Compares the photon map's engines: exact ones find the same photons, so their maps give equal answers.
#include <gtest/gtest.h>

#include <map>

#include "bench/contenders/trace_into.h"
#include "bench/setup/query_points.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;

/// Returns the irradiance at the points that the camera sees.
std::vector<common::Rgb> answers(const std::string& method, const bench::LoadedScene& scene,
                                 const bench::QueryPoints& queries) {
    bench::PreparedScene prepared(scene, {});
    const common::PhotonSource source(scene.scene);
    const bench::Contender contender = bench::parse_contender("", method);
    const std::unique_ptr<bench::Store> store = contender->make_store(prepared, source);
    const auto trace =
        bench::trace_into(*store, {scene.rays, source, 1, {.hits = count_for(200'000, 20'000)}});
    return bench::ask(*contender->finish(*store, trace).answers, queries.image_order);
}

TEST(Engines, AnswerAlike) {
    const bench::LoadedScene scene(SHLMBENCH_BINARY_DIR "/scenes/cornell.glb", {});
    const bench::QueryPoints queries = bench::visible_query_points(scene, 1);
    // Generous upper bounds for the number of photons in a sum; the resulting tolerance for k is still far
    // below the effect of one photon.
    const std::map<std::string, double> photons = {
        {"k50/disc", 50}, {"r0.01/cone", 5'000}, {"r0.1/disc", 200'000}};
    for (const auto& [selection, most] : photons) {
        const auto expected = answers("photonmap/flann/" + selection, scene, queries);
        for (const std::string engine : {"nanoflann", "grid"}) {
            if (engine == "grid" && selection.starts_with("k")) continue;
            const auto found = answers("photonmap/" + engine + "/" + selection, scene, queries);
            ASSERT_EQ(found.size(), expected.size());
            // The sums have the same photons in another order: each addition rounds by 2^-24 at most.
            const double rounding = most * 0x1p-23;
            for (std::size_t i = 0; i < found.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[i][c], expected[i][c], rounding * expected[i][c])
                        << engine << "/" << selection << ", query " << i;
        }
    }
}

}  // namespace
