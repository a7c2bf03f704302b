// Tests the command's output with closed terminals, pipes without a reader, and full disks.
#include "common/core/standard_streams.h"

#include <fmt/format.h>

#include "tests/support/command.h"

namespace {

using namespace command;

/// Returns a shell line that replaces the shell by the program with these arguments.
std::string line_of(const Words& words) {
    std::string line = fmt::format("exec {}/shlmbench", build_folder);
    for (const std::string& word : words) line += " '" + word + "'";
    return line;
}

class Streams : public Command {
  protected:
    /// Runs the command with shell redirections.
    [[nodiscard]] Ended run_with(const Words& words, const std::string& redirections) const {
        return Child("/bin/sh", {"-c", line_of(words) + " " + redirections}, said.path()).wait();
    }

    [[nodiscard]] Words trace(const Words& more) const {
        Words words = {"trace", cornell, "--texels", "1500", "--checkpoint", path("map.exr")};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

TEST_F(Streams, AResultThatCannotBeWrittenIsAnError) {
    const std::vector<Words> all = {{"info", cornell, "--json"},
                                    {"info", cornell},
                                    {"trace", cornell, "--photons", "1000", "--texels", "1500", "--json"},
                                    {"trace", cornell, "--photons", "1000", "--texels", "1500"},
                                    render(cornell, "photonmap"),
                                    {"stability", "--list"},
                                    {"fit", "--list"},
                                    {"--help"}};
    for (const Words& words : all)
        for (const char* redirection : {">/dev/full", ">&-"}) {
            SCOPED_TRACE(testing::PrintToString(words) + redirection);
            const Ended ended = run_with(words, redirection);
            EXPECT_EQ(ended.exit_code, 2);
            EXPECT_EQ(without_progress(ended.err),
                      "shlmbench: the result could not be written to standard output\n");
        }
    // The result is written all the same.
    EXPECT_EQ(files_in(folder.path()), (std::set<std::string>{"image.exr", "image.png"}));
}

TEST_F(Streams, APipeThatNobodyReadsIsNoSignal) {
    const Ended ended = Child("/bin/bash",
                              {"-c", fmt::format("{{ {}; }} | true; exit ${{PIPESTATUS[0]}}",
                                                 "sleep 0.2; " + line_of(trace({"--photons", "1000"})))},
                              said.path())
                            .wait();
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_TRUE(fs::exists(path("map.exr")));
}

TEST_F(Streams, AnErrorThatNobodyReadsEndsAsItEnds) {
    for (const char* redirection : {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
        EXPECT_EQ(run_with({"info", path("none.gltf")}, redirection).exit_code, 2) << redirection;
        EXPECT_EQ(run_with({"rendre"}, redirection).exit_code, 2) << redirection;
    }
}

TEST_F(Streams, AWarningThatNobodyReadsEndsNoWork) {
    // A reference warns about light that it does not find.
    const Words words = {"reference", build_folder + "/scenes/caustic.glb",
                         "--sun",     "0,1,0,1,1,1",
                         "--spp",     "64",
                         "--width",   "16",
                         "--height",  "9",
                         "--out",     path("ref.exr")};
    EXPECT_NE(run(words).err, "");
    fs::remove(path("ref.exr"));
    EXPECT_EQ(run_with(words, "2>/dev/full").exit_code, 0);
    EXPECT_TRUE(fs::exists(path("ref.exr")));
}

TEST_F(Streams, NothingThatIsSaidGetsIntoAFile) {
    // If a standard stream is closed, the first file that is opened would get its number.
    ASSERT_EQ(run(trace({"--photons", "20000"})).exit_code, 0);
    const std::string whole = child_process::text_of(path("map.exr"));
    fs::remove(path("map.exr"));
    EXPECT_EQ(run_with(trace({"--photons", "20000"}), ">&- 2>&-").exit_code, 2);
    EXPECT_TRUE(child_process::text_of(path("map.exr")) == whole);
}

TEST_F(Streams, AClosedTerminalEndsNoWork) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(grantpt(terminal) + unlockpt(terminal), 0);
    Child child("/bin/sh",
                {"-c", line_of(trace({"--hits", "1e12", "--every", "0.01s"})) + " 2>" + ptsname(terminal)},
                said.path());
    char drawn = 0;
    ASSERT_EQ(read(terminal, &drawn, 1), 1) << "no progress is shown";
    close(terminal);
    for (int checkpoint = 0; checkpoint < 3; ++checkpoint) {
        fs::remove(path("map.exr"));
        ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("map.exr")); }));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // three times as long as progress is silent
    child.send(SIGINT);
    EXPECT_EQ(child.wait().exit_code, 130);
    EXPECT_TRUE(fs::exists(path("map.exr")));
}

TEST_F(Streams, AHangUpKeepsWhatThereIs) {
    Child child = start(trace({"--hits", "1e12", "--every", "1h"}));
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGHUP); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    for (int times = 0; times < 3; ++times) child.send(SIGHUP);  // both the shell and the kernel send it
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130) << ended.err;
    EXPECT_TRUE(fs::exists(path("map.exr")));
    EXPECT_EQ(run({"render", cornell, "--method", "shlm", "--map", path("map.exr"), "--texels", "1500",
                   "--out", path("image.exr"), "--width", "16", "--height", "9"})
                  .exit_code,
              0);
}

TEST_F(Streams, WhatIgnoresHangUpsGoesOn) {
    Child child("/bin/sh", {"-c", "trap '' HUP; " + line_of(trace({"--hits", "1e12", "--every", "0.01s"}))},
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("map.exr")); }));
    child.send(SIGHUP);
    for (int checkpoint = 0; checkpoint < 3; ++checkpoint) {
        fs::remove(path("map.exr"));
        ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("map.exr")); }));
    }
    child.send(SIGINT);
    EXPECT_EQ(child.wait().exit_code, 130);
}

TEST_F(Streams, AFileThatMayNotGrowIsAnErrorOfTheWrite) {
    const Ended ended =
        Child("/bin/sh", {"-c", "ulimit -f 4; " + line_of(trace({"--photons", "1000"}))}, said.path()).wait();
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_NE(ended.err.find("cannot be written"), std::string::npos) << ended.err;
    EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST_F(Streams, AComplaintIsOneLineWhateverAFileIsCalled) {
    const Ended ended = run({"info", path("a\nb\r\x1b[31m.gltf")});
    expect_refused(ended, {"a b  [31m.gltf"});
}

TEST(OneLine, HasNoControlCharacters) {
    EXPECT_EQ(common::one_line("a\n\tb\x7f"), "a  b ");
    EXPECT_EQ(common::one_line("木"), "木");
}

}  // namespace
