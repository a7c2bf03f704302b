// Tests shlmbench reference from the user's point of view.
#include "common/image/image.h"
#include "common/reference/reference_image.h"
#include "tests/support/command.h"

namespace {

using namespace command;

const std::string bumpy = build_folder + "/scenes/bumpy.glb";

class ReferenceCommand : public Command {
  protected:
    [[nodiscard]] std::set<std::string> files() const { return files_in(folder.path()); }

    /// Returns the arguments of a small reference, followed by `more`.
    [[nodiscard]] Words reference(const Words& more, const std::string& scene = cornell) const {
        Words words = {"reference", scene, "--out", path("ref.exr"), "--width", "16", "--height", "9"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    Ended expect_success(const Words& words) const {
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return ended;
    }

    /// Expects exit code 2, one line that contains all of `fragments`, and every file unchanged.
    void expect_refusal(const Words& words, const Words& fragments) const {
        SCOPED_TRACE(testing::PrintToString(words));
        const auto before = files();
        const std::string kept = fs::exists(path("ref.exr")) ? child_process::text_of(path("ref.exr")) : "";
        expect_refused(run(words), fragments);
        EXPECT_EQ(files(), before);
        if (!kept.empty()) {
            EXPECT_EQ(child_process::text_of(path("ref.exr")), kept);
        }
    }
};

TEST_F(ReferenceCommand, WritesItsImageWithItsOriginAndAPicture) {
    const Ended ended = expect_success(reference({"--spp", "100", "--seed", "5"}));
    EXPECT_EQ(ended.err, "");
    EXPECT_TRUE(ended.out.starts_with(path("ref.exr") + ": 128 samples per pixel, relative error "))
        << ended.out;
    EXPECT_EQ(files(), (std::set<std::string>{"ref.exr", "ref.png"}));
    const auto image = common::reference::read_reference(path("ref.exr"));
    EXPECT_EQ(image.width, 16);
    EXPECT_EQ(image.height, 9);
    const auto& notes = image.notes;
    EXPECT_EQ(notes.at("shlmbench:scene"), "cornell");
    EXPECT_EQ(notes.at("shlmbench:seed"), "5");
    EXPECT_EQ(notes.at("shlmbench:samples_per_pixel"), "128");
    EXPECT_EQ(notes.at("shlmbench:passes"), "2");
    EXPECT_EQ(notes.at("shlmbench:paths_not_found"), "none");
    EXPECT_EQ(notes.at("shlmbench:samples_dropped"), "0");
    EXPECT_EQ(notes.at("shlmbench:fingerprint").size(), 16u);
    for (const char* name : {"relative_error", "camera", "machine", "instruction_set", "compiler", "flags",
                             "libraries", "commit", "date"})
        EXPECT_NE(notes.at(std::string("shlmbench:") + name), "") << name;
    for (const auto& point : image.pixel) {
        ASSERT_TRUE(point.present);  // the room is closed
        EXPECT_GT(point.irradiance.x, 0);
        EXPECT_GT(point.variance.x, 0);
        EXPECT_NEAR(point.normal.length(), 1, 1e-5);
        EXPECT_GT(point.normal.dot(point.geometric_normal), 0);
    }
}

TEST_F(ReferenceCommand, GoesOnToTheBit) {
    expect_success(reference({"--spp", "320"}));
    const common::Image whole = common::read_image(path("ref.exr"));
    fs::remove(path("ref.exr"));
    expect_success(reference({"--spp", "128", "--threads", "1"}));
    const Ended ended = expect_success(reference({"--spp", "320", "--threads", "3"}));
    EXPECT_TRUE(ended.err.starts_with("going on from " + path("ref.exr") + ": 128 samples per pixel"))
        << ended.err;
    EXPECT_EQ(common::read_image(path("ref.exr")).values, whole.values);
    // If it has enough samples already, the file is not changed.
    const std::string kept = child_process::text_of(path("ref.exr"));
    expect_success(reference({"--spp", "64"}));
    EXPECT_EQ(child_process::text_of(path("ref.exr")), kept);
}

TEST_F(ReferenceCommand, SamplesUntilItIsGoodEnough) {
    expect_success(reference({"--until", "10%"}));
    const auto image = common::reference::read_reference(path("ref.exr"));
    EXPECT_LE(std::stod(image.notes.at("shlmbench:relative_error")), 0.1);
    EXPECT_EQ(std::stoul(image.notes.at("shlmbench:passes")) % 8, 0u);
    // Stopped between two checks of the error, it ends where it would have ended.
    fs::remove(path("ref.exr"));
    expect_success(reference({"--spp", "192"}));
    expect_success(reference({"--until", "10%"}));
    const auto resumed = common::reference::read_reference(path("ref.exr"));
    EXPECT_EQ(resumed.notes.at("shlmbench:passes"), image.notes.at("shlmbench:passes"));
    EXPECT_EQ(resumed.pixel[0].irradiance, image.pixel[0].irradiance);
}

TEST_F(ReferenceCommand, SaysWhichLightItDoesNotFind) {
    const std::string caustic = build_folder + "/scenes/caustic.glb";
    const Ended ended = expect_success(reference({"--spp", "64", "--sun", "0,1,0,1,1,1"}, caustic));
    const std::string lost = "light of 1 directional lights by way of mirrors or glass";
    EXPECT_EQ(ended.err, "caustic: warning: not in the reference: " + lost + "\n");
    EXPECT_EQ(common::read_notes(path("ref.exr")).at("shlmbench:paths_not_found"), lost);
}

TEST_F(ReferenceCommand, InterruptedKeepsWholePassesAndGoesOn) {
    expect_success(reference({"--spp", "128"}));
    Child child(build_folder + "/shlmbench", reference({"--spp", "1e10"}), said.path());
    ASSERT_TRUE(child_process::wait_until(
        [&] { return child_process::text_of(said.path() / "stderr").starts_with("going on"); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_NE(ended.err.find("shlmbench: reference stopped: " + path("ref.exr") + ": "), std::string::npos)
        << ended.err;
    EXPECT_EQ(files(), (std::set<std::string>{"ref.exr", "ref.png"}));
    const common::Image stopped = common::read_image(path("ref.exr"));
    const std::string samples = common::read_notes(path("ref.exr")).at("shlmbench:samples_per_pixel");
    fs::remove(path("ref.exr"));
    expect_success(reference({"--spp", samples}));
    EXPECT_EQ(common::read_image(path("ref.exr")).values, stopped.values);
}

TEST_F(ReferenceCommand, InterruptedBeforeItHasAVarianceWritesNothing) {
    // Two passes over so many pixels take longer than the delivery of a signal.
    Child child(build_folder + "/shlmbench",
                {"reference", cornell, "--out", path("ref.exr"), "--width", "1024", "--height", "1024"},
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGINT); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_EQ(ended.err, "shlmbench: reference stopped: no image is written\n");
    EXPECT_TRUE(files().empty());
}

TEST_F(ReferenceCommand, RefusesOptionsThatMeanNothing) {
    expect_refusal(reference({"--spp", "64", "--until", "1%"}), {"--spp", "--until"});
    for (const char* until : {"1", "0%", "-1%", "100%", "nan%", "%", "1%%", "few"})
        expect_refusal(reference({std::string("--until=") + until}), {"--until"});
    for (const char* spp : {"0", "-1", "1.5", "many", "1e12"})
        expect_refusal(reference({std::string("--spp=") + spp}), {"--spp"});
    expect_refusal({"reference", cornell, "--out", path("ref.exr"), "--width", "0"}, {"--width"});
    expect_refusal({"reference", cornell, "--out", path("ref.png")}, {"--out", ".exr"});
    expect_refusal({"reference", cornell, "--out", path("none/ref.exr")}, {"--out", "none"});
    expect_refusal({"reference", cornell}, {"--out"});
    expect_refusal({"reference", path("none.glb"), "--out", path("ref.exr")}, {"none.glb"});
}

TEST_F(ReferenceCommand, RefusesASceneWithoutLight) {
    const std::string scene = gltf_text::one_triangle().write(folder).string();
    expect_refusal(reference({"--spp", "64"}, scene), {"no light", "--sky"});
    expect_success(reference({"--spp", "64", "--sky", "1,1,1"}, scene));
}

TEST_F(ReferenceCommand, GoesOnFromItsOwnRunOnly) {
    expect_success(reference({"--spp", "128"}));
    const Words more = {"--spp", "1024"};
    expect_refusal(reference({"--spp", "1024", "--seed", "2"}),
                   {"ref.exr", "another seed: 1 there, 2 asked for"});
    expect_refusal({"reference", cornell, "--out", path("ref.exr"), "--width", "32", "--height", "9"},
                   {"another size: 16 x 9 there, 32 x 9 asked for"});
    expect_refusal(reference({"--spp", "1024", "--camera", "0,1,2,0,1,0,60"}), {"another camera"});
    expect_refusal(reference({"--spp", "1024", "--sky", "1,1,1"}), {"another scene fingerprint"});
    expect_refusal(reference(more, bumpy), {"another scene fingerprint"});
    fs::remove(path("ref.exr"));
    expect_success({"render", cornell, "--method", "photonmap", "--hits", "1000", "--out", path("ref.exr"),
                    "--width", "16", "--height", "9"});
    expect_refusal(reference(more), {"ref.exr", "is not a reference"});
    std::ofstream(path("ref.exr")) << "text";
    expect_refusal(reference(more), {"ref.exr", "cannot be read"});
}

}  // namespace
