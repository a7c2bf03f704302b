// Tests the command of the stability cases: what it lists, writes and keeps, and what it refuses.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace {

using namespace command;
using Json = nlohmann::json;

class StabilityCommand : public FolderCommand {
  protected:
    StabilityCommand() : FolderCommand("stability") {}

    [[nodiscard]] std::string text() const { return child_process::text_of(out() / "stability.md"); }

    /// Returns the table's rows after a run of these cases in their short form.
    [[nodiscard]] Json rows_of(Words words) const {
        words.insert(words.end(), {"--short", "--out", out().string()});
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        for (const std::string& name : {words.front(), (out() / "stability.md").string()})
            EXPECT_NE(ended.out.find(name), std::string::npos) << ended.out;
        return Json::parse(child_process::text_of(out() / "stability.json"))["rows"];
    }
};

TEST_F(StabilityCommand, NamesTheCasesAndRunsNone) {
    const Ended ended = run({"--list", "--out", out().string()});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_TRUE(ended.out.starts_with("free-edge ")) << "the first of them: " << ended.out;
    EXPECT_GE(std::count(ended.out.begin(), ended.out.end(), '\n'), 5);
    EXPECT_FALSE(fs::exists(out()));
}

TEST_F(StabilityCommand, WritesTableTextAndChart) {
    const Json rows = rows_of({"free-edge"});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0]["name"], "free-edge");
    EXPECT_EQ(rows[0]["form"], "short");
    EXPECT_EQ(rows[0]["passed"], true);
    ASSERT_EQ(rows[0]["curves"].size(), 4u);
    const Json& curve = rows[0]["curves"][0];
    EXPECT_EQ(curve["expected"], "equal");
    EXPECT_EQ(curve["points"][0]["at"], 0);
    EXPECT_EQ(curve["points"][0]["predicted"], 0.5);
    EXPECT_NEAR(curve["points"][0]["mean"].get<double>(), 0.5, curve["points"][0]["band"].get<double>());
    EXPECT_NE(text().find("## free-edge: as predicted"), std::string::npos);
    EXPECT_NE(text().find("![](charts/free-edge.png)"), std::string::npos);
    EXPECT_GT(fs::file_size(out() / "charts" / "free-edge.png"), 10'000u);
}

TEST_F(StabilityCommand, AddsACaseBesideEarlierOnes) {
    const Json first = rows_of({"cut-texels"});
    ASSERT_EQ(first.size(), 1u);
    const Json both = rows_of({"texel-seams"});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0]["name"], "texel-seams") << "in the order of the issue's list";
    EXPECT_EQ(both[1], first[0]);
    for (const std::string name : {"texel-seams", "cut-texels"}) {
        EXPECT_NE(text().find("## " + name), std::string::npos);
        EXPECT_TRUE(fs::exists(out() / "charts" / (name + ".png")));
    }
    const Json again = rows_of({"texel-seams"});
    ASSERT_EQ(again.size(), 2u) << "in place of its earlier row";
    EXPECT_EQ(again[0]["curves"], both[0]["curves"]) << "the same seeds";
}

TEST_F(StabilityCommand, RefusesANameThatIsNone) {
    const std::string folder_name = out().string();
    expect_refusal({"no-such-case", "--short", "--out", folder_name}, "'no-such-case'");
    expect_refusal({"free-edge", "no-such-case", "--short", "--out", folder_name}, "'no-such-case'");
}

TEST_F(StabilityCommand, RefusesAFolderThatCannotBe) {
    const fs::path file = folder.write("file", std::string("x"));
    expect_refused(run({"free-edge", "--short", "--out", (file / "below").string()}), {"--out"});
}

}  // namespace
