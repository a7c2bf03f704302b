// Tests shlmbench limit: it records the rays of the run, its ratios are within one repetition, and it refuses
// bad input.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "bench/experiments/limit/limit_figures.h"
#include "bench/experiments/limit/replay.h"
#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "tests/support/command.h"

namespace {

using namespace command;
using namespace bench::limit;
using common::Vec3;
using Json = nlohmann::json;

constexpr std::uint64_t seed = 5, few_hits = 3000;  // needs fewer photons than a block

const RecordProgress go_on = [](const RecordedRun&) { return true; };

/// A scene with everything that its rays need.
struct Subject {
    common::Scene scene;
    common::RayScene rays{scene};
    common::PhotonSource source{scene};

    explicit Subject(const std::string& name)
        : scene(common::load_gltf(build_folder + "/scenes/" + name + ".glb")) {}

    [[nodiscard]] RecordedRun record(std::uint64_t hits = few_hits) const {
        return record_run(rays, source, seed, hits, std::size_t{1} << 30, go_on);
    }
};

std::vector<Vec3> directions_of(const std::vector<RayBlock>& blocks) {
    std::vector<Vec3> all;
    for (const RayBlock& block : blocks)
        for (std::size_t i = 0; i < block.size(); ++i) all.push_back(block.direction[i]);
    return all;
}

/// Returns the directions of the recorded rays that hit a diffuse surface.
std::vector<Vec3> arriving(const Subject& subject, const RecordedRun& run) {
    std::vector<Vec3> all;
    for (const RayBlock& block : run.blocks)
        for (std::size_t i = 0; i < block.size(); ++i)
            if (const auto met = subject.rays.nearest(block.origin[i], block.direction[i]);
                met && subject.scene.material_of(met->triangle).kind == common::SurfaceKind::diffuse)
                all.push_back(block.direction[i]);
    return all;
}

/// Returns the directions of a block's hits, photon by photon.
std::vector<Vec3> path_by_path(const common::HitBatch& hits) {
    std::vector<std::size_t> order(hits.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return hits.photon[a] < hits.photon[b]; });
    std::vector<Vec3> all;
    for (const std::size_t i : order) all.push_back(hits.direction[i]);
    return all;
}

// The scene caustic has glass and mirrors, which rays hit without making a hit of the run.
TEST(RecordedRun, HasTheRaysOfATrace) {
    for (const std::string name : {"cornell", "caustic"}) {
        const Subject subject(name);
        const RecordedRun run = subject.record();
        ASSERT_LT(run.report.fates.emitted, common::photons_per_block);
        common::TracedBlock traced;
        common::BlockTracer(subject.rays, subject.source, seed).trace(0, traced);
        EXPECT_EQ(traced.photons_with(few_hits, 0), run.report.fates.emitted) << name;
        traced.keep_photons(0, run.report.fates.emitted);
        common::PhotonFates fates;
        fates.add(traced.fate);
        EXPECT_EQ(run.report.hits, traced.hits.size()) << name;
        EXPECT_EQ(run.report.fates.missed, fates.missed) << name;
        EXPECT_EQ(run.report.fates.escaped, fates.escaped) << name;
        EXPECT_EQ(run.report.fates.absorbed, fates.absorbed) << name;
        EXPECT_EQ(arriving(subject, run), path_by_path(traced.hits)) << name;
        EXPECT_EQ(run.rays > run.report.hits + run.report.fates.missed + run.report.fates.escaped,
                  name == "caustic");
    }
}

TEST(RecordedRun, IsInFullBlocksButTheLast) {
    const RecordedRun run = Subject("cornell").record(10'000);
    ASSERT_EQ(run.blocks.size(), 3u);
    EXPECT_EQ(run.blocks[0].size(), rays_per_block);
    EXPECT_EQ(run.blocks[1].size(), rays_per_block);
    EXPECT_EQ(run.blocks[2].size(), run.rays - 2 * rays_per_block);
}

TEST(RecordedRun, StaysWithinItsMemory) {
    const Subject subject("cornell");
    EXPECT_THROW((void)record_run(subject.rays, subject.source, seed, 1'000'000, 1'000'000, go_on),
                 common::InputError);
}

TEST(RecordedRun, SortedHasTheSameRaysOctantAfterOctant) {
    const Subject subject("cornell");
    const RecordedRun run = subject.record(10'000);
    const auto sorted = sorted_blocks(run.blocks, subject.scene.bounds);
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::vector<Vec3> recorded = directions_of(run.blocks), again = directions_of(sorted);
    std::sort(recorded.begin(), recorded.end(), before);
    std::sort(again.begin(), again.end(), before);
    EXPECT_EQ(recorded, again);
    for (const RayBlock& block : sorted) {
        std::size_t changes = 0;
        for (std::size_t i = 1; i < block.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                changes += (block.direction[i - 1][axis] < 0) != (block.direction[i][axis] < 0);
        EXPECT_LE(changes, 11u);  // counting in binary from 0 to 7
    }
}

TEST(Replay, PacketsFindWhatSingleRaysFind) {
    for (const std::string name : {"cornell", "atrium"}) {  // packets of 16, then of 8
        const Subject subject(name);
        EXPECT_EQ(count_differences(subject.rays, subject.record(20'000).blocks), 0u) << name;
    }
}

/// Everything that is timed, on the scene cornell.
struct Parts {
    bench::LoadedScene loaded{cornell, {}};
    common::PhotonSource source{loaded.scene};
    bench::PreparedScene prepared{loaded, {.texels = {.count = 1024}}};
    LimitSubject subject;

    Parts()
        : subject{loaded,
                  source,
                  prepared,
                  bench::parse_contender("", "shlm"),
                  bench::parse_contender("", "photonmap/compact"),
                  seed,
                  record_run(loaded.rays, source, seed, few_hits, std::size_t{1} << 30, go_on),
                  {}} {
        subject.sorted = sorted_blocks(subject.run.blocks, loaded.scene.bounds);
    }
};

TEST(LimitParts, AnotherRunThanTheRecordedIsNotTimed) {
    Parts parts;
    EXPECT_NO_THROW(check_answers(parts.subject));
    ++parts.subject.run.report.hits;
    EXPECT_THROW(check_answers(parts.subject), std::runtime_error);
}

TEST(LimitParts, EndWhenAskedTo) {
    const Parts parts;
    const LimitSeconds seconds = measure_limit(parts.subject, 3, [](std::size_t done) { return done < 8; });
    EXPECT_EQ(seconds[static_cast<std::size_t>(LimitPart::single)].size(), 1u);
    EXPECT_EQ(seconds[static_cast<std::size_t>(LimitPart::sorted_single)].size(), 2u);
    EXPECT_EQ(seconds[static_cast<std::size_t>(LimitPart::packet)].size(), 1u);
}

TEST(LimitFigures, AreOfTheSameRepetition) {
    const PairedRatio ratio = paired_ratio({1, 20, 9}, {2, 10, 3});
    EXPECT_EQ(ratio.median, 2);
    EXPECT_EQ(ratio.smallest, 0.5);
    EXPECT_EQ(ratio.largest, 3);
}

TEST(LimitFigures, RatesAreTimesTurnedRound) {
    const Parts parts;
    LimitSeconds seconds;
    seconds.fill({1, 1, 1});
    seconds[static_cast<std::size_t>(LimitPart::packet)] = {0.5, 0.25, 1};
    seconds[static_cast<std::size_t>(LimitPart::null)] = {4, 2, 2};
    const auto all = limit_as_json(parts.subject, seconds, 2);
    EXPECT_EQ(all["packet_ratio"], 2);
    EXPECT_EQ(all["packet_ratio_range"], (std::vector<double>{1, 4}));
    EXPECT_EQ(all["null_ratio"], 0.5);
    EXPECT_EQ(all["shlm_over_null"], 0.5);
    EXPECT_EQ(all["rays_per_second"]["packet"], 2.0 * static_cast<double>(parts.subject.run.rays));
}

// The command.

class Limit : public Command {
  protected:
    [[nodiscard]] static Words small(const std::string& scene, const Words& more = {}) {
        Words words = {"limit", scene, "--hits", "20000", "--repeat", "3", "--texels", "4096"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] Json measured(const Words& more) const {
        const Ended ended = run(small(cornell, more));
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_EQ(ended.err, "");
        return Json::parse(ended.out);
    }
};

TEST_F(Limit, SaysItsRatiosAsJson) {
    const Json all = measured({"--json"});
    for (const std::string name :
         {"packet_ratio", "sorted_packet_ratio", "sorted_single_ratio", "null_ratio", "shlm_ratio",
          "photonmap_ratio", "shlm_over_null", "photonmap_over_null"}) {
        const double median = all.at(name).get<double>();
        EXPECT_TRUE(std::isfinite(median)) << name;
        EXPECT_GT(median, 0) << name;
        EXPECT_LE(all.at(name + "_range")[0].get<double>(), median) << name;
        EXPECT_GE(all.at(name + "_range")[1].get<double>(), median) << name;
    }
    for (const auto part : limit_part_names) {
        EXPECT_EQ(all.at("seconds").at(part).size(), 3u) << part;
        EXPECT_GT(all.at("rays_per_second").at(part), 0) << part;
    }
    EXPECT_GE(all.at("hits"), 20000);
    EXPECT_EQ(all.at("differing_rays"), 0);
    EXPECT_EQ(all.at("light_map"), "shlm/L2/radiance/surface4");
    EXPECT_EQ(all.at("photon_map"), "photonmap/compact/k50/disc");
    EXPECT_TRUE(all.at("context").contains("commit"));
}

TEST_F(Limit, ReplaysTheSameRunWithAnyNumberOfThreads) {
    const Json one = measured({"--json", "--threads", "1"}), two = measured({"--json", "--threads", "2"});
    EXPECT_EQ(one["threads"], 1);
    EXPECT_EQ(two["threads"], 2);
    for (const char* what : {"hits", "photons", "rays"}) EXPECT_EQ(one[what], two[what]) << what;
    EXPECT_NE(one["rays"], measured({"--json", "--seed", "2"})["rays"]);
}

TEST_F(Limit, SaysThemAsATable) {
    const Ended ended = run(small(cornell, {"--shlm", "shlm/F1", "--photonmap", "photonmap/flann"}));
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    for (const std::string part : {"Embree alone, single rays", "tracing into shlm/F1/radiance/surface4",
                                   "tracing into photonmap/flann/k50/disc"})
        EXPECT_NE(ended.out.find(part), std::string::npos) << ended.out;
}

TEST_F(Limit, SaysWhatItCannotDo) {
    expect_refusal(small(path("no-such-scene.glb")), {"no-such-scene.glb"});
    expect_refusal(small(write(gltf_text::one_triangle())), {"scene.gltf", "light", "--sky", "--sun"});
    for (const std::string number : {"2", "4", "1", "-3", "1001", "some"})
        expect_refusal(small(cornell, {"--repeat=" + number}), {"--repeat"});
    expect_refusal(small(cornell, {"--threads", "-1"}), {"--threads"});
    expect_refusal(small(cornell, {"--shlm", "photonmap"}), {"--shlm", "light map"});
    expect_refusal(small(cornell, {"--photonmap", "shlm"}), {"--photonmap", "photon map"});
    expect_refusal({"limit", cornell, "--hits", "0"}, {"--hits"});
    expect_refusal({"limit", cornell, "--hits", "1e15"}, {"photonmap/compact"});
}

TEST_F(Limit, EndsWithCtrlC) {
    Child child(build_folder + "/shlmbench", {"limit", cornell, "--hits", "1e6", "--repeat", "999"},
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGINT); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_EQ(ended.out, "");
    EXPECT_TRUE(ended.err.starts_with("shlmbench: limit stopped: ")) << ended.err;
}

}  // namespace
