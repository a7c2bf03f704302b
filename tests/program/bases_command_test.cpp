// Tests shlmbench bases from the user's point of view.
#include "tests/support/command.h"

namespace {

using namespace command;
using Json = nlohmann::json;

class BasesCommand : public FolderCommand {
  protected:
    BasesCommand() : FolderCommand("bases") {}

    [[nodiscard]] Json document_of(const Words& more) const {
        Words words = {"--environments", "5", "--out", out().string()};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_EQ(ended.err, "");
        return Json::parse(child_process::text_of(out() / "bases.json"));
    }
};

TEST_F(BasesCommand, WritesTableTextAndCharts) {
    const Json document = document_of({});
    ASSERT_EQ(document["rows"].size(), 4 * 20u);
    EXPECT_EQ(document["context"]["seed"], 1);
    EXPECT_TRUE(document["context"].contains("commit"));
    EXPECT_EQ(document["lights"].size(), 4u);
    const Json& row = document["rows"][6];
    EXPECT_EQ(row["light"], "point light");
    EXPECT_EQ(row["basis"], "L2/radiance");
    EXPECT_EQ(row["numbers_per_texel"], 27);
    EXPECT_EQ(row["bytes_per_texel"], 108);
    EXPECT_EQ(row["environments"], 5);
    EXPECT_EQ(row["expected_mean"], 8.7);
    EXPECT_EQ(row["expected_worst"], 14);
    EXPECT_GT(row["worst"], row["mean"]);
    EXPECT_TRUE(document["rows"][2]["expected_mean"].is_null());
    EXPECT_EQ(document["tilt"]["series"].size(), 20u);
    EXPECT_NE(child_process::text_of(out() / "bases.md").find("| mixed room | L4/radiance | 54 | 216 | 5 |"),
              std::string::npos);
    for (const std::string name : {"bases.png", "bases-tilt.png"})
        EXPECT_GT(fs::file_size(out() / "charts" / name), 10'000u) << name;
}

TEST_F(BasesCommand, TheSeedDecidesTheEnvironmentsAlone) {
    const Json first = document_of({})["rows"], again = document_of({})["rows"];
    const Json other = document_of({"--seed", "2"})["rows"];
    EXPECT_EQ(first, again);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i]["light"] == "uniform hemisphere")
            EXPECT_EQ(first[i], other[i]);
        else
            EXPECT_NE(first[i]["mean"], other[i]["mean"]) << i;
}

TEST_F(BasesCommand, SaysWhatItCannotDo) {
    const std::string folder_name = out().string();
    for (const std::string number : {"0", "-3", "100001", "many", "2.5"})
        expect_refusal({"--environments", number, "--out", folder_name}, "--environments");
    expect_refusal({"--seed", "-1", "--out", folder_name}, "--seed");
    expect_refusal({}, "--out");
    const fs::path file = folder.write("file", std::string("x"));
    expect_refusal({"--out", (file / "below").string()}, "--out");
}

}  // namespace
