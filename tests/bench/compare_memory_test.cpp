// Tests the memory limit of shlmbench compare: a method that does not fit is not started, one that exceeds
// the limit is ended, and the others continue.
#include "bench/contenders/memory_need.h"
#include "bench/experiments/compare/measure_method.h"
#include "bench/experiments/compare/row.h"
#include "common/core/memory_use.h"
#include "tests/support/command.h"
#include "tests/support/statistics.h"

namespace {

using namespace bench::compare;
using namespace command;
using child_process::text_of;
using tests::count_for;
using Json = nlohmann::json;
using CompareMemory = Command;

constexpr bool sanitized = count_for(0, 1) == 1;  // freed memory stays with the sanitizer

/// Makes a room of white emitting walls in a larger one. No photon ends before the tracer terminates it, so a
/// single block of photons has a million hits, whatever number was asked for. The larger room catches the few
/// photons that slip through an edge in thousands of bounces.
GltfFile white_room() {
    std::vector<float> positions;
    for (int wall = 0; wall < 12; ++wall)
        for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
            std::array<float, 3> corner{};
            const int axis = wall % 6 / 2;
            corner[axis] = wall % 2 ? 1 : -1;
            corner[(axis + 1) % 3] = s ? 1 : -1;
            corner[(axis + 2) % 3] = t ? 1 : -1;
            for (float& c : corner) c *= wall < 6 ? 1.0f : 1.2f;
            positions.insert(positions.end(), corner.begin(), corner.end());
        }
    GltfFile file = gltf_text::one_triangle();
    file.primitive()["attributes"]["POSITION"] = file.add_accessor(positions, gltf_text::f32, "VEC3");
    file.material() = {{"doubleSided", true},
                       {"emissiveFactor", {1, 1, 1}},
                       {"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    return file;
}

TEST_F(CompareMemory, EndsAMethodThatGrowsPastItsBoundAndGoesOn) {
    if (sanitized) GTEST_SKIP() << "a block of photons with all the events there can be";
    const Ended ended =
        run({"compare", write(white_room()), cornell, "--hits", "1000", "--repetitions", "2", "--methods",
             "photonmap/flann,photonmap/nanoflann", "--max-memory", "70MiB", "--out", path("results")});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json rows = Json::parse(text_of(path("results/compare.json")))["rows"];
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(rows[i]["needed_bytes"], rows[i]["max_memory_bytes"]) << "it was started";
        ASSERT_TRUE(rows[i].contains("skipped"));
        EXPECT_TRUE(
            rows[i]["skipped"].get<std::string>().starts_with("grew past --max-memory, 0.0684 GiB, at "))
            << rows[i];
    }
    for (std::size_t i = 2; i < 4; ++i) {
        EXPECT_FALSE(rows[i].contains("skipped")) << rows[i];
        EXPECT_LT(rows[i]["peak_growth_bytes"], 70 << 20);
    }
}

TEST_F(CompareMemory, SaysWhatWouldBeNeeded) {
    const Ended ended = run({"compare", cornell, "--hits", "1000,1e9", "--repetitions", "1", "--methods",
                             "photonmap/grid", "--max-memory", "1GiB", "--out", path("results")});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json rows = Json::parse(text_of(path("results/compare.json")))["rows"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_FALSE(rows[0].contains("skipped"));
    EXPECT_EQ(rows[1]["skipped"], "needs 67.1 GiB");
    EXPECT_GT(rows[1]["needed_bytes"], 7e10);
    EXPECT_EQ(rows[1]["max_memory_bytes"], 1 << 30);
}

TEST(CompareRow, SaysWhereThePeakIsNotOfTheRunAlone) {
    RowInput input;
    input.method = bench::parse_contender("", "photonmap");
    input.queries = 1;
    input.null_sink.emplace_back().trace_seconds = 1;
    Measurement m;
    m.trace.hits = 1;
    m.resident_before_bytes = 100;
    m.peak_resident_bytes = 350;
    input.measurements = {m};
    EXPECT_EQ(make_row(input)["peak_growth_bytes"], 250);
    input.measurements.front().peak_is_of_this_run = false;
    const auto row = make_row(input);
    EXPECT_FALSE(row.contains("peak_growth_bytes"));
    EXPECT_EQ(row["peak_rss_note"], "since the process began: the system does not let it be reset");
}

class MeasureMethod : public testing::Test {
  protected:
    const bench::LoadedScene scene{cornell, {}};
    const bench::QueryPoints queries = bench::visible_query_points(scene, 1);
    const common::PhotonSource source{scene.scene};
    bench::PreparedScene prepared{scene, {}};

    Measurement measure(const std::string& name, std::uint64_t hits, std::size_t max_bytes) {
        return measure_method(bench::parse_contender("", name), prepared,
                              {scene, source, queries, 1, {.hits = hits}, {}, max_bytes});
    }
};

TEST_F(MeasureMethod, GivesTheMemoryBack) {
    if (sanitized) GTEST_SKIP() << "freed memory stays with the sanitizer";
    const std::size_t before = common::resident_bytes();
    const Measurement m = measure("photonmap/flann-incremental", 5'000'000, 300 << 20);
    EXPECT_TRUE(m.given_up.starts_with("grew past --max-memory, 0.293 GiB, at ")) << m.given_up;
    EXPECT_LT(m.trace.hits, 5'000'000u);
    EXPECT_GT(common::peak_resident_bytes(), before + (300u << 20));
    common::reset_peak_resident_bytes();
    EXPECT_LT(common::resident_bytes(), before + (60u << 20)) << "batches and buffers of the threads";
}

TEST_F(MeasureMethod, NeedsNoMoreThanWasComputed) {
    if (sanitized) GTEST_SKIP() << "sanitizers add to all memory";
    for (const char* name :
         {"photonmap/flann", "photonmap/nanoflann", "photonmap/grid", "photonmap/grid/r0.000001",
          "photonmap/flann-incremental", "shlm", "shlm/L2/radiance/own/half", "shlm/a5"})
        for (const std::uint64_t hits : {10'000, 1'000'000}) {
            const std::size_t needed = bench::needed_bytes(bench::parse_contender("", name), {}, hits);
            const Measurement m = measure(name, hits, needed);
            EXPECT_EQ(m.given_up, "") << name;
            if (!m.peak_is_of_this_run) GTEST_SKIP() << "the peak cannot be reset here";
            EXPECT_LE(m.peak_resident_bytes, m.resident_before_bytes + needed) << name << ", " << hits;
        }
}

}  // namespace
