// Tests shlmbench trace and merge from the user's point of view: what is kept, continued, merged and refused.
#include <fmt/format.h>

#include <random>

#include "common/core/input_error.h"
#include "common/image/image.h"
#include "shlm/file/map_file.h"
#include "tests/support/command.h"
#include "tests/support/statistics.h"

namespace {

using namespace command;
using child_process::text_of;

class Checkpoint : public Command {
  protected:
    /// Returns the arguments of a small trace, followed by `more`.
    [[nodiscard]] static Words trace(const Words& more, const std::string& scene = cornell) {
        Words words = {"trace", scene, "--texels", "1500"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    /// Makes the file of an uninterrupted run.
    std::string made(const std::string& name, const Words& more) const {
        Words words = trace(more);
        words.insert(words.end(), {"--checkpoint", path(name)});
        expect_success(words);
        return path(name);
    }

    void expect_same_file(const std::string& a, const std::string& b) const {
        EXPECT_TRUE(text_of(a) == text_of(b)) << a << " and " << b << " differ";
    }
};

shlm::MapRun run_in(const std::string& file) {
    return shlm::MapFileReader(file).run();
}

TEST_F(Checkpoint, AResumedRunEndsAsAnUninterruptedOne) {
    const Words to_photons = {"--photons", "30001"}, to_hits = {"--hits", "100000"};
    for (const auto& [target, method] :
         {std::pair(to_photons, "shlm"), std::pair(to_hits, "shlm"), std::pair(to_hits, "shlm/L0/normalised"),
          std::pair(to_photons, "shlm/L4/flux"), std::pair(to_photons, "shlm/L2/radiance/knn4/face")}) {
        SCOPED_TRACE(target[0] + " " + method);
        for (const auto& entry : fs::directory_iterator(folder.path())) fs::remove(entry);
        Words all = target;
        all.insert(all.end(), {"--method", method});
        const std::string whole = made("whole.exr", all);
        const std::string pieces =
            made("pieces.exr", {"--photons", "700", "--threads", "1", "--method", method});
        Words rest = all;
        rest.insert(rest.end(), {"--resume", pieces, "--threads", "3"});
        expect_success(trace({"--photons", "2817", "--method", method, "--resume", pieces}));
        expect_success(trace(rest));
        expect_same_file(pieces, whole);
        expect_success(trace(rest));
        expect_same_file(pieces, whole);
    }
}

TEST(MapRunNotes, CountPhotonsWithoutLightWhereThereAreAny) {
    shlm::MapRun run;
    run.fates = {.emitted = 10, .missed = 1, .escaped = 2, .absorbed = 3, .given_up = 4};
    EXPECT_FALSE(shlm::to_notes(run).contains("shlmbench:photons_without_light")) << "as files always were";
    EXPECT_EQ(shlm::map_run_of(shlm::to_notes(run)).fates.without_light, 0u);
    run.fates.without_light = 5;
    EXPECT_EQ(shlm::map_run_of(shlm::to_notes(run)).fates.without_light, 5u);
}

TEST_F(Checkpoint, HoldsWhatTheRunWas) {
    const std::string file = made("map.exr", {"--photons", "5000", "--seed", "7"});
    const shlm::MapRun run = run_in(file);
    EXPECT_EQ(run.identity.seed, 7u);
    EXPECT_EQ(run.identity.texels_wanted, "1500");
    EXPECT_EQ(run.identity.model, "L2/radiance");
    EXPECT_EQ(run.first_photon, 0u);
    EXPECT_EQ(run.end_photon(), 5000u);
    shlm::MapFileReader reader(file);
    const std::size_t pixels = reader.size().pixels();
    std::vector<std::int64_t> planes(3 * pixels);
    std::int64_t light = 0;
    for (std::uint64_t number = 0; number < reader.size().numbers; ++number) {
        reader.read_number(planes);
        if (number == 0) light = std::accumulate(planes.begin(), planes.end(), std::int64_t{0});
    }
    EXPECT_GT(light, 0);
    reader.read_hits(std::span(planes).first(pixels));
    const auto hits = static_cast<std::uint64_t>(std::accumulate(
        planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(pixels), std::int64_t{0}));
    EXPECT_EQ(hits + run.rejected.total(), run.hits);
    EXPECT_NO_THROW(reader.check());
    // Any viewer can show the first part.
    const common::Image preview = common::read_image(file);
    EXPECT_TRUE(preview.find_channel("R") && preview.find_channel("G") && preview.find_channel("B"));
    EXPECT_GT(std::accumulate(preview.values.begin(), preview.values.end(), 0.0), 0);
}

TEST_F(Checkpoint, MergedPiecesAreOneRun) {
    const std::string whole = made("whole.exr", {"--photons", "20000"});
    const std::string a = made("a.exr", {"--photons", "6000"});
    const std::string b = made("b.exr", {"--photons", "100", "--first-photon", "6000"});
    const std::string c = made("c.exr", {"--photons", "13900", "--first-photon", "6100"});
    expect_success({"merge", c, a, b, "--out", path("merged.exr")});
    expect_same_file(path("merged.exr"), whole);
    const std::string ab = path("ab.exr");
    expect_success({"merge", a, b, "--out", ab});
    expect_success({"merge", ab, c, "--out", path("merged.exr")});
    expect_same_file(path("merged.exr"), whole);
}

TEST_F(Checkpoint, PiecesThatAreNoRunAreNotMerged) {
    const std::string a = made("a.exr", {"--photons", "600"});
    const std::string after_gap = made("gap.exr", {"--photons", "100", "--first-photon", "700"});
    const std::string overlapping = made("overlap.exr", {"--photons", "100", "--first-photon", "599"});
    const std::string seed = made("seed.exr", {"--photons", "100", "--first-photon", "600", "--seed", "2"});
    const std::string kind =
        made("kind.exr", {"--photons", "100", "--first-photon", "600", "--method", "shlm/F1"});
    const std::string out = path("out.exr");
    expect_refusal({"merge", a, after_gap, "--out", out}, {"photons 600 to 699 are missing", after_gap});
    expect_refusal({"merge", a, overlapping, "--out", out}, {"both have photons 599 to 599", overlapping});
    expect_refusal({"merge", a, a, "--out", out}, {"both have photons 0 to 599"});
    expect_refusal({"merge", a, seed, "--out", out}, {seed, "seed 2, not 1"});
    expect_refusal({"merge", a, kind, "--out", out}, {kind, "L1/radiance, not L2/radiance"});
    expect_refusal({"merge", a, "--out", out}, {"at least two"});
    expect_refusal({"merge", a, path("none.exr"), "--out", out}, {"none.exr"});
    expect_refusal({"merge", a, seed, "--out", path("no/out.exr")}, {"no folder"});
}

TEST_F(Checkpoint, FilesOfAnotherRunAreRefused) {
    const std::string file = made("map.exr", {"--photons", "1000"});
    const Words resume = {"--photons", "2000", "--resume", file};
    const auto refused = [&](Words more, const Words& fragments, const std::string& scene = cornell) {
        more.insert(more.end(), resume.begin(), resume.end());
        expect_refusal(trace(more, scene), fragments);
    };
    const std::string kept = text_of(file);
    refused({"--seed", "2"}, {file, "seed 1, not 2"});
    refused({"--method", "shlm/F1"}, {file, "L2/radiance, not L1/radiance"});
    refused({"--method", "shlm/L2/flux"}, {file, "L2/radiance, not L2/flux"});
    refused({"--method", "shlm/L2/radiance/knn4/t2000"}, {file, "texels 1500, not 2000"});
    refused({"--method", "shlm/L2/radiance/knn4/face"}, {file, "texels 1500, not face,1500"});
    refused({"--sky", "1,1,1"}, {file, "fingerprint"});
    refused({}, {file, "fingerprint"}, build_folder + "/scenes/bumpy.glb");
    refused({"--first-photon", "5"}, {file, "begins at photon 0, not 5"});
    expect_refusal(trace({"--photons", "10", "--resume", file}), {file, "1000 photons already"});
    expect_refusal(trace({"--photons", "10", "--checkpoint", file}), {file, "there already"});
    expect_refusal(trace({"--photons", "10", "--resume", path("none.exr")}), {"none.exr"});
    expect_refusal(trace({"--photons", "10", "--checkpoint", path("map.png")}), {"not an .exr"});
    expect_refusal(trace({"--photons", "10", "--checkpoint", path("no/map.exr")}), {"no folder"});
    expect_refusal(trace({"--photons", "10", "--every", "soon", "--checkpoint", path("b.exr")}), {"--every"});
    expect_refusal(trace({"--photons", "10", "--method", "photonmap"}), {"only a light map"});
    EXPECT_TRUE(text_of(file) == kept);
}

TEST_F(Checkpoint, FilesThatAreNoneAreRefused) {
    const Words resume = trace({"--photons", "2000", "--resume", path("map.exr")});
    std::ofstream(path("map.exr")) << "no image";
    expect_refusal(resume, {"map.exr", "cannot be used"});
    std::ofstream(path("map.exr"), std::ios::trunc);
    expect_refusal(resume, {"map.exr", "cannot be used"});
    fs::remove(path("map.exr"));
    common::write_exr(path("map.exr"), {2, 1, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}}, {});
    expect_refusal(resume, {"map.exr", "not a light map's checkpoint"});
}

/// Returns all numbers of a file, which is read completely and checked.
std::vector<std::int64_t> numbers_in(const std::string& file) {
    shlm::MapFileReader reader(file);
    const std::size_t plane = reader.size().pixels(), number = 3 * plane;
    std::vector<std::int64_t> all(reader.size().numbers * number + plane);
    for (std::uint64_t i = 0; i < reader.size().numbers; ++i)
        reader.read_number(std::span(all).subspan(i * number, number));
    reader.read_hits(std::span(all).last(plane));
    reader.check();
    return all;
}

TEST_F(Checkpoint, ABrokenFileIsRefusedOrDoesNotMatter) {
    constexpr unsigned seed = 1;
    const std::string file = made("map.exr", {"--photons", "1000", "--method", "shlm/L0"});
    const std::string good = text_of(file);
    const std::vector<std::int64_t> numbers = numbers_in(file);
    std::mt19937 random(seed);
    for (int i = 0; i < 20; ++i) {
        const std::size_t length = std::uniform_int_distribution<std::size_t>(0, good.size() - 1)(random);
        std::ofstream(file, std::ios::binary) << good.substr(0, length);
        EXPECT_THROW(numbers_in(file), common::InputError)
            << "cut to " << length << " of " << good.size() << " bytes, seed " << seed;
    }
    expect_refusal(trace({"--photons", "2000", "--method", "shlm/L0", "--resume", file}),
                   {file, "cannot be used"});

    int refused = 0;
    constexpr int damages = 300;
    for (int i = 0; i < damages; ++i) {
        std::string bad = good;
        // Half of the damaged bytes are in the header, where the effects are most diverse.
        const std::size_t end = i % 2 == 0 ? good.size() : 3000;
        const std::size_t place = std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
        bad[place] = static_cast<char>(bad[place] ^ (1 << (random() % 8)));
        std::ofstream(file, std::ios::binary) << bad;
        try {
            EXPECT_TRUE(numbers_in(file) == numbers)  // the damage may be in the preview
                << "bit flipped in byte " << place << " of " << good.size() << ", seed " << seed;
        } catch (const common::InputError& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, damages / 2);
}

TEST_F(Checkpoint, InterruptedItKeepsWhatItHas) {
    Child child = start(trace({"--hits", "1e12", "--every", "0.02s", "--checkpoint", path("map.exr")}));
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("map.exr")); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    const std::uint64_t photons = run_in(path("map.exr")).end_photon();
    EXPECT_NE(ended.err.find("--resume " + path("map.exr")), std::string::npos) << ended.err;
    EXPECT_EQ(files_in(folder.path()), std::set<std::string>{"map.exr"});

    const std::string target = std::to_string(photons + 1000);
    expect_success(trace({"--photons", target, "--resume", path("map.exr")}));
    expect_same_file(path("map.exr"), made("whole.exr", {"--photons", target}));
}

TEST_F(Checkpoint, AFullDiskLeavesTheLastOne) {
    const std::string file = made("map.exr", {"--photons", "1000"});
    const std::string kept = text_of(file);
    // A limit on the size of files acts like a disk that is full at the same point in every run.
    const std::string command = fmt::format(
        "trap '' XFSZ; ulimit -f 50; exec {}/shlmbench trace {} --texels 1500 --photons 2000 --resume {}",
        build_folder, cornell, file);
    const Ended ended = Child("/bin/sh", {"-c", command}, said.path()).wait();
    expect_refused(ended, {file, "cannot be written", "File too large"});
    EXPECT_TRUE(text_of(file) == kept);
    EXPECT_EQ(files_in(folder.path()), std::set<std::string>{"map.exr"});
}

TEST_F(Checkpoint, IsDrawnAsIfTracedOnTheSpot) {
    const std::string file = made("map.exr", {"--photons", "20000"});
    const Words size = {"--method", "shlm", "--texels", "1500", "--width", "32", "--height", "18"};
    const auto draw = [&](const std::string& name, Words words) {
        words.insert(words.begin(), {"render", cornell, "--out", path(name)});
        words.insert(words.end(), size.begin(), size.end());
        expect_success(words);
        return common::read_image(path(name)).values;
    };
    EXPECT_EQ(draw("map-image.exr", {"--map", file}), draw("traced.exr", {"--photons", "20000"}));
    const Words words = {"render", cornell, "--map", file, "--out", path("x.exr")};
    const auto with = [&](Words more) {
        more.insert(more.begin(), words.begin(), words.end());
        return more;
    };
    expect_refusal(with({"--method", "photonmap"}), {"--map"});
    expect_refusal(with({"--method", "shlm"}), {file, "texels 1500, not 262144"});
    expect_refusal(with({"--method", "shlm", "--hits", "1e4"}), {"--map"});
}

TEST_F(Checkpoint, SaysInTheEndWhatItDid) {
    const Ended ended = run(trace({"--photons", "5000", "--json"}));
    EXPECT_EQ(ended.exit_code, 0);
    for (const char* key : {"\"hits\"", "\"photons\": 5000", "\"hits_per_second\"", "\"peak_resident_bytes\"",
                            "\"seconds\"", "\"seed\": 1"})
        EXPECT_NE(ended.out.find(key), std::string::npos) << key << "\n" << ended.out;
    EXPECT_TRUE(files_in(folder.path()).empty());
}

}  // namespace
