// Tests all long work: it can be interrupted, says so, and leaves no incomplete file if the disk fails.
#include <fmt/format.h>

#include "tests/support/command.h"

namespace {

using namespace command;

struct LongWork {
    std::string name;
    Words words;      ///< takes minutes
    Words shortened;  ///< the same within seconds
    std::string out;  ///< output path below a folder

    friend void PrintTo(const LongWork& work, std::ostream* out) { *out << work.name; }
};

/// The commands without their output option.
const std::vector<LongWork> all = {
    {"render", {"render", cornell, "--method", "shlm", "--hits", "1e12"}, {"--hits", "1e4"}, "image.exr"},
    {"trace", {"trace", cornell, "--hits", "1e12", "--texels", "1500"}, {"--hits", "1e4"}, "map.exr"},
    {"reference",
     {"reference", cornell, "--width", "32", "--height", "18", "--until", "0.0001%"},
     {"--until", "50%"},
     "reference.exr"},
    {"compare", {"compare", cornell, "--hits", "1e12", "--methods", "shlm"}, {"--hits", "1e4"}, "compare"},
    {"bases", {"bases", "--environments", "100000"}, {"--environments", "2"}, "bases"},
    {"stability", {"stability"}, {"dim-light", "--short"}, "stability"}};

class LongWorkOf : public Command, public testing::WithParamInterface<LongWork> {
  protected:
    /// Returns the arguments with the output at `place`. Options given twice take the value of the later one.
    [[nodiscard]] Words words_to(const std::string& place, bool shortened) const {
        Words words = GetParam().words;
        words.insert(words.end(), {GetParam().name == "trace" ? "--checkpoint" : "--out", place});
        if (!shortened) return words;
        const Words& more = GetParam().shortened;
        for (std::size_t i = 0; i < more.size(); ++i) {
            const auto found = std::find(words.begin(), words.end(), more[i]);
            if (found == words.end())
                words.push_back(more[i]);
            else
                *(found + 1) = more[++i];
        }
        return words;
    }

    /// Expects no file with a name that is used only during writing.
    void expect_no_half_files() const {
        for (const std::string& name : files_in(folder.path())) {
            EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
            EXPECT_FALSE(name.ends_with(".part") || name.ends_with(".lock")) << name;
            EXPECT_FALSE(fs::path(name).filename().string().starts_with('.')) << name;
        }
    }
};

TEST_P(LongWorkOf, StopsWhenItIsTold) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Child child = start(words_to(path(fmt::format("{}-{}", signal, GetParam().out)), false));
        ASSERT_TRUE(child_process::wait_until([&] { return child.catches(signal); }));
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        child.send(signal);
        const Ended ended = child.wait();
        EXPECT_EQ(ended.exit_code, 130) << ended.err;
        EXPECT_NE(ended.err.find("shlmbench: "), std::string::npos) << ended.err;
        expect_no_half_files();
    }
}

TEST_P(LongWorkOf, SaysThatTheDiskIsFull) {
    // A limit on the size of files acts like a disk that is full at the same point in every run.
    std::string line = fmt::format("trap '' XFSZ; ulimit -f 4; exec {}/shlmbench", build_folder);
    for (const std::string& word : words_to(path(GetParam().out), true)) line += " '" + word + "'";
    const Ended ended = Child("/bin/sh", {"-c", line}, said.path()).wait();
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_NE(ended.err.find("cannot be written"), std::string::npos) << ended.err;
    expect_no_half_files();
}

TEST_P(LongWorkOf, RefusesAFolderThatCannotBeWrittenToBeforeItBegins) {
    expect_refusal(words_to("/proc/" + GetParam().out, false), {"/proc"});
}

INSTANTIATE_TEST_SUITE_P(Commands, LongWorkOf, testing::ValuesIn(all),
                         [](const auto& test) { return test.param.name; });

}  // namespace
