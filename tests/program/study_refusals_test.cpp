// Tests where shlmbench study cannot continue: bad input, and Ctrl-C.
#include "tests/support/study_command.h"

namespace {

using namespace study_command;

// Tests of what it refuses.

TEST_F(Study, RefusesAFolderOfOtherSettings) {
    const Request request = {
        .out = path("out"), .methods = {"shlm"}, .hits = "1000", .seeds = "1", .more = {"--threads", "2"}};
    (void)study(request);
    const auto with = [&](const Words& more) {
        Request other = request;
        other.more.insert(other.more.end(), more.begin(), more.end());
        return other;
    };
    const Words fragments = {"out/study.json", "another build, machine or setting", "--anew", "--out"};
    Request other = request;
    other.texels = "512";
    expect_refusal(other, fragments);
    other = request;
    other.more = {"--threads", "1"};
    expect_refusal(other, fragments);
    expect_refusal(with({"--max-radius", "0.5"}), fragments);
    expect_refusal(with({"--sky", "1,1,1"}), fragments);
    // Another camera sees different points.
    expect_refusal(with({"--camera", "0,1,1,0,1,0,60"}), fragments);
    // A table of another build.
    Json table = table_of(path("out"));
    table["context"]["built"] = "1970-01-01T00:00:00Z";
    std::ofstream(path("out/study.json")) << table.dump();
    expect_refusal(request, fragments);
    // With --anew it starts again.
    const std::size_t rows = table["rows"].size();
    table["rows"][0]["hits"] = 1;
    std::ofstream(path("out/study.json")) << table.dump();
    (void)study(with({"--anew"}));
    EXPECT_EQ(table_of(path("out"))["rows"].size(), rows);
    EXPECT_NE(table_of(path("out"))["rows"][0]["hits"], 1);
}

TEST_F(Study, RefusesToMixPoints) {
    fs::create_directory(path("references"));
    make_reference("references/cornell.exr", {"--width", "32", "--height", "18"});
    Request request = {.out = path("out"), .methods = {"shlm"}, .hits = "1000", .seeds = "1"};
    (void)study(request);
    request.references = path("references");
    request.seeds = "2";
    const Contents before = contents_of(path("out"));
    const Ended ended = run(request);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_NE(
        ended.err.find("out/study.json: the rows of cornell are for another width: 16 there, 32 asked for"),
        std::string::npos)
        << ended.err;
    EXPECT_TRUE(contents_of(path("out")) == before);
}

TEST_F(Study, RefusesReferencesThatAreNone) {
    fs::create_directories(path("out"));
    fs::create_directories(path("references"));
    const Request request = {.out = path("out"), .references = path("references")};
    expect_refusal(request, {"--references: there is no ", "references/cornell.exr", "shlmbench reference"});
    Request nowhere = request;
    nowhere.references = path("none");
    expect_refusal(nowhere, {"--references: there is no ", "none/cornell.exr"});

    std::ofstream(path("references/cornell.exr")) << "text";
    expect_refusal(request, {"references/cornell.exr", "cannot be read"});
    ASSERT_EQ(run_command({"render", cornell, "--method", "photonmap", "--hits", "1000", "--width", "16",
                           "--height", "9", "--out", path("picture.exr")},
                          said)
                  .exit_code,
              0);
    fs::copy_file(path("picture.exr"), path("references/cornell.exr"), fs::copy_options::overwrite_existing);
    expect_refusal(request, {"references/cornell.exr", "is not a reference"});
}

TEST_F(Study, RefusesAReferenceThatLacksLightWhichPhotonsFind) {
    fs::create_directories(path("out"));
    fs::create_directories(path("references"));
    const std::string caustic = build_folder + "/scenes/caustic.glb";
    const Words sun = {"--sun", "0,1,0,1,1,1"};  // no path reaches it through the glass ball
    Words words = {"reference", caustic,    "--spp", "64",    "--width",
                   "16",        "--height", "9",     "--out", path("references/caustic.exr")};
    words.insert(words.end(), sun.begin(), sun.end());
    ASSERT_EQ(run_command(words, said).exit_code, 0);
    const Request request = {
        .out = path("out"), .more = sun, .references = path("references"), .scene = caustic};
    expect_refusal(request, {"references/caustic.exr", "no measure for photons", "1 directional lights"});
}

TEST_F(Study, RefusesAReferenceOfAnotherSceneOrCamera) {
    fs::create_directories(path("out"));
    fs::create_directories(path("references"));
    const Request request = {.out = path("out"), .references = path("references")};
    make_reference("references/cornell.exr",
                   {"--width", "16", "--height", "9", "--camera", "0,1,1,0,1,0,60"});
    expect_refusal(request, {"references/cornell.exr", "looks at other points", "another scene or camera"});
    // The reference belongs to another scene than its name says.
    fs::copy_file(references() / "cornell.exr", path("references/bumpy.exr"));
    Request other_scene = request;
    other_scene.scene = build_folder + "/scenes/bumpy.glb";
    expect_refusal(other_scene, {"references/bumpy.exr", "looks at other points", "bumpy.glb"});
}

TEST_F(Study, RefusesOptionsThatMeanNothing) {
    fs::create_directories(path("out"));
    folder.write("file", "");
    const Request request = {.out = path("out")};
    const auto with = [&](auto change) {
        Request changed = request;
        change(changed);
        return changed;
    };
    for (const char* seeds : {"0", "-1", "1001", "two"})
        expect_refusal(with([&](Request& r) { r.seeds = seeds; }), {"--seeds"});
    for (const char* hits : {"0", "nan", "1e3,inf", "text"})
        expect_refusal(with([&](Request& r) { r.hits = hits; }), {"--hits"});
    for (const char* method : {"oak", "photonmap/flann/k1"})
        expect_refusal(with([&](Request& r) { r.methods = {"shlm", method}; }), {"--methods", method});
    expect_refusal(with([&](Request& r) { r.texels = "0"; }), {"--texels"});
    for (const char* option : {"--threads=-1", "--max-memory=little", "--sky=blue", "--camera=1"})
        expect_refusal(with([&](Request& r) { r.more = {option}; }),
                       {std::string(option).substr(0, std::string(option).find('='))});
    expect_refusal(with([&](Request& r) { r.out = path("file"); }), {"--out", "file"});
    fs::create_directory(path("blocked"));
    folder.write("blocked/raw", "");
    expect_refusal(with([&](Request& r) { r.out = path("blocked"); }), {"--out", "blocked/raw"});
    expect_refusal(with([&](Request& r) { r.scene = path("cornell.glb"); }), {"cornell.glb"});
    expect_refusal(with([&](Request& r) { r.more = {cornell}; }), {"cornell"});
}

// Ctrl-C.

TEST_F(Study, InterruptedKeepsFinishedRowsAndGoesOn) {
    // With as many seeds as possible, the signal comes long before the last.
    Request request = {.out = path("out"), .hits = "20000", .seeds = "1000"};
    Child child(build_folder + "/shlmbench", words_of(request), said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("out/study.json")); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    const Json rows = rows_of(path("out"));
    ASSERT_GE(rows.size(), some_methods.size());
    ASSERT_LT(rows.size(), 1000 * some_methods.size());
    EXPECT_EQ(ended.out, "");
    EXPECT_NE(ended.err.find("shlmbench: study stopped: " + std::to_string(rows.size()) +
                             " finished rows are in " + path("out/study.json") + "\n"),
              std::string::npos)
        << ended.err;
    EXPECT_EQ(rows.size() % some_methods.size(), 0u) << "whole runs";
    EXPECT_FALSE(fs::exists(path("out/report.md")));

    request.seeds = std::to_string(rows.size() / some_methods.size() + 1);
    const Json after = study(request);
    ASSERT_EQ(after.size(), rows.size() + some_methods.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Json kept = after[i];
        kept.erase("flip");  // comes with the report
        EXPECT_EQ(kept, rows[i]) << "times included";
    }
    EXPECT_TRUE(fs::exists(path("out/report.md")));
    // The measurements are those of a run without the signal.
    request.out = path("whole");
    expect_same_rows(after, study(request));
    EXPECT_TRUE(contents_of(path("out/raw")) == contents_of(path("whole/raw")));
}

TEST_F(Study, InterruptedWhileTracingLeavesNoUnfinishedRow) {
    // The second size takes longer than the delivery of a signal.
    Request request = {
        .out = path("out"), .methods = {"shlm/L2/radiance/own"}, .hits = "1000,1e14", .seeds = "2"};
    Child child(build_folder + "/shlmbench", words_of(request), said.path());
    ASSERT_TRUE(child_process::wait_until(
        [&] { return fs::exists(path("out/study.json")) && rows_of(path("out")).size() == 2; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_EQ(keys_of(rows_of(path("out"))),
              (std::set<Key>{{request.methods[0], 1000, 1}, {request.methods[0], 1000, 2}}));
    for (const auto& [name, content] : contents_of(path("out")))
        EXPECT_EQ(name.find("100000000000000"), std::string::npos) << name;
}

TEST_F(Study, InterruptedBeforeItsFirstRowLeavesNoTable) {
    Child child(build_folder + "/shlmbench", words_of({.out = path("out"), .hits = "1e14", .seeds = "1"}),
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGINT); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_FALSE(fs::exists(path("out/study.json")));
}

}  // namespace
