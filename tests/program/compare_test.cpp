// Tests shlmbench compare: its table, and how it grows over several runs.
#include "tests/support/command.h"

namespace {

using namespace command;
using child_process::text_of;
using Json = nlohmann::json;
using Compare = Command;

TEST_F(Compare, WritesItsTable) {
    const std::string out = path("results");
    const Ended ended =
        run({"compare", cornell, "--hits", "2000", "--repetitions", "1", "--max-memory", "100MiB",
             "--methods", "photonmap,photonmap/flann-incremental,shlm,photonmap/flann", "--out", out});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json table = Json::parse(text_of(out + "/compare.json"));
    for (const char* key : {"machine", "instruction_set", "commit", "compiler", "flags", "libraries", "date",
                            "seed", "threads", "settings"})
        EXPECT_TRUE(table["context"].contains(key)) << key;
    ASSERT_EQ(table["rows"].size(), 3u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Json& row = table["rows"][i];
        EXPECT_EQ(row["scene"], "cornell");
        EXPECT_EQ(row["method"],
                  i == 0 ? "photonmap/flann/k50/disc" : "photonmap/flann-incremental/k50/disc");
        EXPECT_GE(row["hits"], 2000);
        for (const char* key : {"photons_emitted", "trace_seconds", "build_seconds", "gather_us_per_query",
                                "bytes", "peak_rss_bytes", "prepare_seconds", "prepare_bytes"}) {
            ASSERT_TRUE(row.contains(key)) << key;
            EXPECT_GT(row[key], 0) << key;
        }
        // The difference of two clocked runs, which noise makes negative at so few hits.
        ASSERT_TRUE(row.contains("insert_ns_per_hit"));
        EXPECT_TRUE(row["insert_ns_per_hit"].is_number());
    }
    const Json& skipped = table["rows"][2];
    EXPECT_EQ(skipped["method"], "shlm/L2/radiance/surface4");
    EXPECT_TRUE(skipped["skipped"].get<std::string>().starts_with("needs "));

    const std::string csv = text_of(out + "/compare.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
    EXPECT_TRUE(csv.starts_with("scene,method,"));
}

TEST_F(Compare, SaysWhyALightMapIsNotToBeHad) {
    const std::string scene = write(gltf_text::one_triangle());
    const Ended ended = run({"compare", scene, "--hits", "500", "--repetitions", "1", "--methods",
                             "photonmap,shlm", "--sky", "1,1,1", "--texels", "uv", "--out", path("results")});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json rows = Json::parse(text_of(path("results/compare.json")))["rows"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_FALSE(rows[0].contains("skipped"));
    EXPECT_NE(rows[1]["skipped"].get<std::string>().find("TEXCOORD_1"), std::string::npos);
}

/// Returns the arguments of a small comparison.
Words small(const std::string& scene, const std::string& out, const Words& more,
            const std::string& repetitions = "1") {
    Words words = {"compare", scene, "--hits", "1000", "--repetitions", repetitions, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST_F(Compare, GoesOnWhereItWas) {
    const std::string out = path("results");
    const auto rows_after = [&](const Words& words) {
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return Json::parse(text_of(out + "/compare.json"))["rows"];
    };
    // At first the light map does not fit into memory.
    const Words methods = {"--methods", "photonmap,shlm"};
    const auto with = [&](Words more) {
        more.insert(more.end(), methods.begin(), methods.end());
        return small(cornell, out, more);
    };
    const Json first = rows_after(with({"--max-memory", "100MiB"}));
    ASSERT_EQ(first.size(), 2u);
    EXPECT_TRUE(first[1].contains("skipped"));
    // A method that is not asked for now keeps its row, even if it was skipped.
    const Json same = rows_after(small(cornell, out, {"--methods", "photonmap"}));
    EXPECT_EQ(same, first) << "not even timings differ";
    const Json second = rows_after(with({}));
    ASSERT_EQ(second.size(), 2u);
    EXPECT_EQ(second[0], first[0]);
    EXPECT_FALSE(second[1].contains("skipped"));
    // More repetitions replace the old rows; fewer of another size are added beside them.
    const Json more = rows_after(small(cornell, out, methods, "2"));
    ASSERT_EQ(more.size(), 2u);
    EXPECT_NE(more[0], first[0]);
    Words larger = small(cornell, out, methods);
    larger[3] = "2000";
    const Json both = rows_after(larger);
    ASSERT_EQ(both.size(), 4u);
    EXPECT_EQ(both[0], more[0]);
    EXPECT_EQ(both[1], more[1]);
}

TEST_F(Compare, DoesNotTakeAnotherSceneOfTheSameNameForItsOwn) {
    const std::string out = path("results"), scene = path("cornell.glb");
    const Words methods = {"--methods", "photonmap"};
    fs::copy_file(cornell, scene);
    ASSERT_EQ(run(small(scene, out, methods)).exit_code, 0);
    const Json first = Json::parse(text_of(out + "/compare.json"))["rows"];
    fs::copy_file(build_folder + "/scenes/caustic.glb", scene, fs::copy_options::overwrite_existing);
    ASSERT_EQ(run(small(scene, out, methods)).exit_code, 0);
    const Json second = Json::parse(text_of(out + "/compare.json"))["rows"];
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0]["scene"], first[0]["scene"]);
    EXPECT_NE(second[0]["mean_irradiance"], first[0]["mean_irradiance"]);
}

TEST_F(Compare, DoesNotOverwriteWhatIsNoTable) {
    fs::create_directory(path("results"));
    for (const char* text :
         {"", "{", "[]", R"({"context": 1, "rows": []})", R"({"context": {}, "rows": 1})"}) {
        folder.write("results/compare.json", text);
        expect_refusal(small(cornell, path("results"), {}), {"compare.json", "not a table"});
        EXPECT_EQ(text_of(path("results/compare.json")), text);
    }
}

TEST_F(Compare, KeepsItsFinishedRowsWhenStopped) {
    Child child(build_folder + "/shlmbench",
                {"compare", cornell, "--methods", "shlm", "--hits", "1000,1e14", "--repetitions", "1",
                 "--out", folder.path()},
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("compare.csv")); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_EQ(ended.err, "shlmbench: compare stopped: 1 finished rows are in " + path("compare.json") + "\n");
    const Json rows = Json::parse(text_of(path("compare.json")))["rows"];
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_GE(rows[0]["hits"], 1000);
    EXPECT_EQ(files_in(folder.path()), (std::set<std::string>{"compare.csv", "compare.json"}));
}

}  // namespace
