// Tests existing files: no result replaces its own inputs, or anything that the command has not made. Of two
// writers, one is refused.
#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/core/output_file.h"
#include "common/core/output_lock.h"
#include "common/gltf/source_files.h"
#include "common/image/image.h"
#include "tests/support/command.h"

namespace {

using namespace command;
using child_process::text_of;

class KeptFiles : public Command {
  protected:
    /// Returns the arguments of a small trace, followed by `more`.
    [[nodiscard]] static Words trace(const Words& more) {
        Words words = {"trace", cornell, "--texels", "1500"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] Words render_to(const std::string& out, const Words& more = {"--hits", "1000"}) const {
        Words words = {"render", cornell, "--method", "shlm", "--texels", "1500",
                       "--out",  out,     "--width",  "16",   "--height", "9"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] Words reference_to(const std::string& out) const {
        return {"reference", cornell, "--spp", "128", "--out", out, "--width", "16", "--height", "9"};
    }

    /// Expects a refusal, and every file unchanged.
    void expect_kept(const Words& words, const Words& fragments) const {
        SCOPED_TRACE(testing::PrintToString(words));
        const std::map<std::string, std::string> before = texts();
        expect_refused(run(words), fragments);
        EXPECT_EQ(texts(), before);
    }

    /// Returns the contents of all files.
    [[nodiscard]] std::map<std::string, std::string> texts() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : files_in(folder.path()))
            all[name] = fs::is_regular_file(path(name)) ? text_of(path(name)) : "";
        return all;
    }
};

TEST_F(KeptFiles, AMapIsNotReplacedByItsPicture) {
    expect_success(trace({"--photons", "1000", "--checkpoint", path("map.exr")}));
    const Words from_map = {"--map", path("map.exr")};
    fs::create_symlink(path("map.exr"), path("soft.exr"));
    fs::create_hard_link(path("map.exr"), path("hard.exr"));
    fs::create_directory(path("sub"));
    for (const std::string& out :
         {path("map.exr"), path("./map.exr"), path("sub/../map.exr"), path("soft.exr"), path("hard.exr")})
        expect_kept(render_to(out, from_map), {"--out", fs::path(out).filename(), "map.exr"});
    expect_kept(render_to(path("map.exr")), {"--out", "map.exr is there already"});
    expect_success(trace({"--photons", "2000", "--resume", path("map.exr")}));
}

TEST_F(KeptFiles, OnlyARenderedImageIsReplacedByAnother) {
    expect_success(render_to(path("a.exr")));
    expect_success(render_to(path("a.exr"), {"--hits", "2000"}));
    expect_success(reference_to(path("reference.exr")));
    common::write_exr(path("foreign.exr"), {2, 1, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}}, {});
    folder.write("text.exr", "text");
    folder.write("empty.exr", "");
    for (const char* name : {"reference.exr", "foreign.exr", "text.exr", "empty.exr"})
        expect_kept(render_to(path(name)), {"--out", name, "there already"});
    ASSERT_EQ(mkfifo(path("pipe.exr").c_str(), 0600), 0);
    expect_kept(render_to(path("pipe.exr")), {"--out", "pipe.exr is no regular file"});
}

TEST_F(KeptFiles, OnlyItsOwnPngIsReplaced) {
    folder.write("a.png", "of somebody else");
    expect_kept(render_to(path("a.exr")), {"--out", "a.png is there already"});
    expect_kept(reference_to(path("a.exr")), {"--out", "a.png is there already"});
    fs::remove(path("a.png"));
    fs::create_directory(path("a.png"));
    expect_kept(render_to(path("a.exr")), {"--out", "a.png is a folder"});
    fs::remove(path("a.png"));
    expect_success(render_to(path("a.exr")));
    // Without its notes it may be anybody's work, such as hours of painting.
    common::Image png = common::read_image(path("a.png"));
    png.channels = {"R", "G", "B"};
    fs::remove(path("a.png"));
    expect_success({"diff", path("a.exr"), path("a.exr"), "--flip-map", path("a.png")});
    expect_kept(render_to(path("a.exr")), {"--out", "a.png is there already"});
}

TEST_F(KeptFiles, ATextureIsNotReplacedByAPicture) {
    // The texture is a picture that the program itself has made.
    expect_success(render_to(path("wall one.exr")));
    GltfFile file = gltf_text::one_triangle();
    file.document["images"] = {{{"uri", "wall%20one.png"}}};
    file.document["textures"] = {{{"source", 0}}};
    file.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    const std::string scene = write(file);
    Words words = render_to(path("wall one.exr"));
    words[1] = scene;
    words.insert(words.end(), {"--sky", "1,1,1"});
    expect_kept(words, {"--out", "wall one.png", "which is read"});
    fs::remove(path("wall one.exr"));
    expect_kept(words, {"--out", "wall one.png", "which is read"});
    expect_kept({"reference", scene, "--sky", "1,1,1", "--out", path("wall one.exr")},
                {"--out", "wall one.png", "which is read"});
}

TEST_F(KeptFiles, AFlipMapReplacesNothingElse) {
    expect_success(render_to(path("a.exr")));
    const auto diff_to = [&](const std::string& map) {
        return Words{"diff", path("a.exr"), path("a.exr"), "--flip-map", path(map)};
    };
    fs::create_symlink(path("a.exr"), path("link.png"));
    folder.write("text.png", "text");
    for (const char* name : {"a.png", "link.png", "text.png"})
        expect_kept(diff_to(name), {"--flip-map", name, "there already"});
    EXPECT_EQ(run(diff_to("map.png")).exit_code, 0);
    EXPECT_EQ(run(diff_to("map.png")).exit_code, 0);
}

TEST_F(KeptFiles, MergingReplacesNoPieceAndLosesNoPhoton) {
    const std::string a = path("a.exr"), b = path("b.exr"), c = path("c.exr");
    expect_success(trace({"--photons", "600", "--checkpoint", a}));
    expect_success(trace({"--photons", "100", "--first-photon", "600", "--checkpoint", b}));
    expect_success(trace({"--photons", "900", "--first-photon", "700", "--checkpoint", c}));
    fs::create_symlink(a, path("link.exr"));
    for (const std::string& out : {a, path("./b.exr"), path("link.exr")})
        expect_kept({"merge", a, b, "--out", out}, {"--out", "which is read"});
    fs::copy_file(a, path("d.exr.part"));
    expect_kept({"merge", path("d.exr.part"), b, "--out", path("d.exr")}, {"--out", "which is read"});
    expect_kept({"merge", a, b, "--out", c}, {"--out", "c.exr is there already", "photons"});
    folder.write("text.exr", "text");
    expect_kept({"merge", a, b, "--out", path("text.exr")}, {"text.exr"});
    // A map that is part of the new one may be replaced.
    expect_success({"merge", a, b, "--out", path("all.exr")});
    expect_success({"merge", a, b, c, "--out", path("all.exr")});
    expect_kept({"merge", a, b, "--out", path("all.exr")}, {"--out", "all.exr is there already", "photons"});
}

TEST_F(KeptFiles, AUnfinishedFileOfSomebodyElseIsInTheWay) {
    folder.write("map.exr.part", "half of a download");
    expect_kept(trace({"--photons", "1000", "--checkpoint", path("map.exr")}),
                {"map.exr.part", "in the way"});
    // A file as a run leaves it if it is killed while writing.
    for (const char* text : {"", "\x76\x2f", "\x76\x2f\x31\x01 and so on"}) {
        fs::remove(path("map.exr"));
        folder.write("map.exr.part", text);
        expect_success(trace({"--photons", "1000", "--checkpoint", path("map.exr")}));
        EXPECT_EQ(files_in(folder.path()), std::set<std::string>{"map.exr"});
    }
}

TEST_F(KeptFiles, ResumingThroughALinkWritesTheFile) {
    fs::create_directory(path("large disk"));
    expect_success(trace({"--photons", "1000", "--checkpoint", path("large disk/map.exr")}));
    fs::create_symlink(path("large disk/map.exr"), path("map.exr"));
    const std::string before = text_of(path("map.exr"));
    expect_success(trace({"--photons", "2000", "--resume", path("map.exr")}));
    EXPECT_TRUE(fs::is_symlink(path("map.exr")));
    EXPECT_NE(text_of(path("large disk/map.exr")), before);
}

TEST_F(KeptFiles, ResultFoldersReplaceOnlyResults) {
    const std::vector<std::pair<Words, Words>> all = {
        {{"bases", "--environments", "1"}, {"bases.json", "bases.md"}},
        {{"stability", "dim-light", "--short"}, {"stability.json", "stability.md"}},
        {{"compare", cornell, "--hits", "1000", "--methods", "shlm"}, {"compare.json", "compare.csv"}},
        {{"fit", cornell, "--target", "50%"}, {"fit.json", "fit.md", "models.json"}}};
    for (const auto& [command, names] : all)
        for (const std::string& name : names) {
            fs::remove_all(path("out"));
            fs::create_directory(path("out"));
            folder.write("out/" + name, "{\"of\": \"somebody else\"}");
            Words words = command;
            words.insert(words.end(), {"--out", path("out")});
            expect_kept(words, {name});
        }
}

TEST_F(KeptFiles, ResultFoldersDoNotHoldTheirScenes) {
    fs::create_directories(path("out/charts"));
    fs::copy_file(cornell, path("out/charts/room.glb"));
    expect_kept({"compare", path("out/charts/room.glb"), "--hits", "1000", "--out", path("out")},
                {"--out", "room.glb", "lies in"});
    fs::create_symlink(path("out/charts/room.glb"), path("room.glb"));
    expect_kept({"compare", path("room.glb"), "--hits", "1000", "--out", path("out")},
                {"--out", "room.glb", "lies in"});
    fs::rename(path("out/charts/room.glb"), path("out/fit.md"));
    expect_kept({"fit", path("out/fit.md"), "--target", "50%", "--out", path("out")}, {"--out", "fit.md"});
    fs::remove_all(path("out"));
    folder.write("out", "");
    expect_kept({"fit", cornell, "--target", "50%", "--out", path("out")}, {"--out", "out"});
    fs::remove(path("out"));
    fs::create_directory(path("out"));
    folder.write("out/images", "");
    expect_kept({"compare", cornell, "--hits", "1000", "--out", path("out")}, {"--out", "images"});
}

TEST_F(KeptFiles, ANameThatIsTooLongIsRefusedBeforeTheWork) {
    // The name is short enough by itself, but not with the suffix that is added during writing.
    const std::string name = std::string(248, 'x') + ".exr";
    expect_kept(render_to(path(name), {"--hits", "1e12"}), {"--out", "too long"});
    expect_kept(trace({"--hits", "1e12", "--checkpoint", path(name)}), {"--checkpoint", "too long"});
    for (const char* odd :
         {"with space.exr", "木.exr", "new\nline.exr", "-dash.exr", "'quote\".exr", "$x.exr"}) {
        EXPECT_EQ(run(render_to(path(odd))).exit_code, 0) << odd;
        EXPECT_TRUE(fs::exists(path(odd)));
    }
}

// Tests with two writers.

TEST_F(KeptFiles, OfTwoWritersOneIsRefusedAtOnce) {
    const std::string out = path("map.exr");
    Child first = start(trace({"--hits", "1e12", "--every", "0.01s", "--checkpoint", out}));
    // The second one is refused before the first checkpoint and after it.
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(out + ".lock"); }));
    const gltf_text::TemporaryDirectory said_by_others;
    const auto expect_second_refused = [&](const Words& words) {
        expect_refused(run_command(words, said_by_others), {"another run is writing", "map.exr"});
    };
    expect_second_refused(trace({"--photons", "1000", "--seed", "2", "--checkpoint", out}));
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(out); }));
    expect_second_refused(trace({"--photons", "1e12", "--resume", out}));
    fs::create_symlink(out, path("link.exr"));
    expect_second_refused(trace({"--photons", "1e12", "--resume", path("link.exr")}));
    first.send(SIGINT);
    EXPECT_EQ(first.wait().exit_code, 130);
    EXPECT_EQ(files_in(folder.path()), (std::set<std::string>{"link.exr", "map.exr"}));
    expect_success(render_to(path("image.exr"), {"--map", out}));
}

TEST_F(KeptFiles, ADeadWriterKeepsNobodyWaiting) {
    const std::string out = path("map.exr");
    Child first = start(trace({"--hits", "1e12", "--every", "0.01s", "--checkpoint", out}));
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(out); }));
    first.send(SIGKILL);
    (void)first.wait();
    EXPECT_TRUE(fs::exists(out + ".lock"));
    fs::remove(out);
    expect_success(trace({"--photons", "1000", "--checkpoint", out}));
    EXPECT_EQ(files_in(folder.path()), (std::set<std::string>{"map.exr"}));
}

TEST_F(KeptFiles, OtherLongWorkHasOneWriterToo) {
    const std::vector<std::pair<Words, std::string>> all = {
        {{"reference", cornell, "--width", "32", "--height", "18", "--spp", "1e10"}, "out.exr"},
        {{"compare", cornell, "--hits", "1e14", "--methods", "shlm"}, "compare"},
        {{"bases", "--environments", "100000"}, "bases"},
        {{"stability"}, "stability"}};
    for (const auto& [command, out] : all) {
        Words words = command;
        words.insert(words.end(), {"--out", path(out)});
        SCOPED_TRACE(words.front());
        Child first = start(words);
        const std::string lock =
            out == "out.exr" ? path("out.exr.lock") : path(out + "/" + out + ".json.lock");
        ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(lock); }));
        const gltf_text::TemporaryDirectory said_by_others;
        expect_refused(run_command(words, said_by_others), {"another run is writing"});
        first.send(SIGINT);
        EXPECT_EQ(first.wait().exit_code, 130);
        EXPECT_FALSE(fs::exists(lock));
    }
}

TEST_F(KeptFiles, ALockFileOfSomebodyElseStays) {
    folder.write("map.exr.lock", "text");
    expect_success(trace({"--photons", "1000", "--checkpoint", path("map.exr")}));
    EXPECT_EQ(text_of(path("map.exr.lock")), "text");
}

TEST_F(KeptFiles, ALockIsHeldAsLongAsItLives) {
    {
        const common::OutputLock lock("--out", path("x"));
        EXPECT_THROW(common::OutputLock("--out", path("x")), common::InputError);
        const common::OutputLock other("--out", path("y"));
    }
    const common::OutputLock again("--out", path("x"));
    EXPECT_EQ(files_in(folder.path()), std::set<std::string>{"x.lock"});
}

// Tests of the parts.

TEST_F(KeptFiles, SourceFilesAreAllThatASceneIsReadFrom) {
    folder.write("scene.gltf",
                 R"({"buffers": [{"uri": "a%20b.bin"}, {"uri": "data:;base64,AAAA"}, {"byteLength": 3}],
                                   "images": [{"uri": "sub/x.png"}, {"bufferView": 0}, 7]})");
    const auto files = common::source_files(path("scene.gltf"));
    const std::set<fs::path> found(files.begin(), files.end());
    EXPECT_EQ(found, (std::set<fs::path>{path("scene.gltf"), path("a%20b.bin"), path("a b.bin"),
                                         path("sub/x.png")}));
    for (const char* text : {"", "{", "[]", "{\"images\": {\"uri\": 1}}"}) {
        folder.write("bad.gltf", text);
        EXPECT_EQ(common::source_files(path("bad.gltf")).size(), 1u) << text;
    }
    EXPECT_EQ(common::source_files(path("none.gltf")).size(), 1u);
}

}  // namespace
