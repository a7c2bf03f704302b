// Tests shlmbench fit from the user's point of view.
#include <sstream>

#include "tests/support/command.h"
#include "tests/support/statistics.h"

namespace {

using namespace command;
using child_process::text_of;
using Json = nlohmann::json;

constexpr double target = 0.4;

/// A whole search takes minutes in slow builds, and these tests check its answers only.
#define ONLY_WHERE_OPTIMISED \
    if (tests::count_for(1, 0) == 0) GTEST_SKIP() << "answers, which the optimised build checks"

class Fit : public Command {
  protected:
    /// Returns a search with the smallest possible pilot, and a target that needs no larger one.
    [[nodiscard]] static Words fit(const Words& more = {}, const std::string& wanted = "40%",
                                   const std::string& pilot = "25000") {
        Words words = {"fit", cornell, "--target", wanted, "--pilot", pilot, "--max-hits", "1e6"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] Json json_of(const Words& more, const std::string& wanted = "40%",
                               const std::string& pilot = "25000") const {
        Words words = fit(more, wanted, pilot);
        words.emplace_back("--json");
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_EQ(ended.err, "");
        return Json::parse(ended.out);
    }

    void make_reference(const std::string& name) const {
        expect_success(
            {"reference", cornell, "--width", "32", "--height", "18", "--spp", "64", "--out", path(name)});
    }
};

bool is_adaptive(const Json& choice) {
    return choice["method"].get<std::string>().starts_with("shlm/a");
}

double sum_of_squares(const Json& row) {
    double sum = 0;
    for (const char* part : {"noise", "blur", "truncation"}) sum += std::pow(row[part].get<double>(), 2);
    return sum;
}

TEST_F(Fit, ChoosesBothKindsAndSplitsTheirErrors) {
    const Json found = json_of({});
    EXPECT_EQ(found["scene"], "cornell");
    EXPECT_EQ(found["target"], target);
    EXPECT_EQ(found["seed"], 1);
    EXPECT_TRUE(found["context"].contains("commit"));
    EXPECT_FALSE(found.contains("reference"));
    for (const char* kind : {"light_map", "photon_map"}) {
        SCOPED_TRACE(kind);
        const Json& entry = found[kind];
        ASSERT_TRUE(entry["reached"].get<bool>()) << entry;
        const Json& choice = entry["choice"];
        EXPECT_GT(choice["prepare_seconds"], 0);
        EXPECT_TRUE(choice["method"].get<std::string>().starts_with(*kind == 'l' ? "shlm/" : "photonmap/"));
        EXPECT_NEAR(std::pow(choice["error"].get<double>(), 2), sum_of_squares(choice), 1e-9);
        EXPECT_LE(choice["error"], choice["bound"]);
        EXPECT_LE(choice["bound"].get<double>(), target + 1e-6);
        if (!is_adaptive(choice)) {
            EXPECT_GT(choice["bound"].get<double>(), target - 0.01) << "no more hits than it takes";
        }
        EXPECT_GT(choice["seconds"], 0);
        EXPECT_GT(choice["bytes"], 0);
        EXPECT_FALSE(entry.contains("verified"));
    }
}

TEST_F(Fit, MeetsTheTargetThatItWasGiven) {
    make_reference("reference.exr");
    const Json found = json_of({"--verify", path("reference.exr"), "--seeds", "4"});
    for (const char* kind : {"light_map", "photon_map"}) {
        const Json& runs = found[kind]["verified"];
        ASSERT_EQ(runs.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(runs[i]["seed"], i + 2) << "not the pilot's";
            EXPECT_GE(runs[i]["hits"], found[kind]["choice"]["hits"]);
            // These points differ from the fit's and are coarser.
            EXPECT_LT(runs[i]["error"], 1.2 * target) << kind;
            if (!is_adaptive(found[kind]["choice"])) {
                EXPECT_GT(runs[i]["error"], target / 2) << kind << ": far more than was asked for";
            }
        }
    }
}

TEST_F(Fit, WritesWhatItSays) {
    const Ended ended = run(fit({"--out", path("out")}));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(files_in(path("out")), (std::set<std::string>{"fit.json", "fit.md", "models.json"}));
    const Json found = Json::parse(text_of(path("out/fit.json")));
    const std::string name = found["light_map"]["choice"]["method"];
    EXPECT_NE(ended.out.find(name), std::string::npos) << ended.out;
    EXPECT_NE(text_of(path("out/fit.md")).find("| " + name + " |"), std::string::npos);
    EXPECT_EQ(found["light_maps"][0], found["light_map"]["choice"]);
    EXPECT_GT(Json::parse(text_of(path("out/models.json"))).size(), 100u) << "of all candidates";
}

TEST_F(Fit, SeveralGoalsAreAnsweredAsEachAlone) {
    ONLY_WHERE_OPTIMISED;
    ASSERT_EQ(run(fit({"--least", "bytes", "--out", path("all")}, "40%,50%")).exit_code, 0);
    std::set<std::string> files;
    for (const std::string goal : {"40-bytes", "50-bytes"}) {
        files.insert(goal);
        for (const char* name : {"fit.json", "fit.md", "models.json"}) files.insert(goal + "/" + name);
    }
    EXPECT_EQ(files_in(path("all")), files);
    ASSERT_EQ(run(fit({"--least", "bytes", "--out", path("alone")}, "50%")).exit_code, 0);
    EXPECT_EQ(text_of(path("all/50-bytes/models.json")), text_of(path("alone/models.json")));
    Json together = Json::parse(text_of(path("all/50-bytes/fit.json")));
    Json alone = Json::parse(text_of(path("alone/fit.json")));
    for (const char* kind : {"light_map", "photon_map"}) {
        for (Json* found : {&together, &alone})
            for (const char* time : {"seconds", "prepare_seconds"}) (*found)[kind]["choice"].erase(time);
        EXPECT_EQ(together[kind], alone[kind]);
    }
}

TEST_F(Fit, ExplainsWhereErrorArisesAndWhatIsKept) {
    const Ended ended = run(fit({"--explain", "--least", "bytes", "--out", path("out")}, "40%", "40000"));
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(files_in(path("out")), (std::set<std::string>{"fit.json", "fit.md", "models.json",
                                                            "explanation.json", "explanation.png"}));
    const Json found = Json::parse(text_of(path("out/fit.json")));
    EXPECT_TRUE(is_adaptive(found["light_map"]["choice"])) << "the fewest bytes";
    const Json& surfaces = found["explanation"];
    EXPECT_EQ(surfaces.size(), 6u) << "the white walls, two in colour, two blocks and the lamp";
    double points = 0, error_share = 0, error_sq = 0;
    for (const Json& surface : surfaces) {
        points += surface["points"].get<double>();
        error_share += surface["error_share"].get<double>();
        error_sq += surface["points"].get<double>() * std::pow(surface["error"].get<double>(), 2);
        double kept = 0;
        for (const auto& [kind, share] : surface["blocks"]["kinds"].items()) kept += share.get<double>();
        EXPECT_NEAR(kept, 1, 1e-9);
        EXPECT_GT(surface["blocks"]["median_width"], 0);
    }
    EXPECT_NEAR(points, 1, 1e-9);
    EXPECT_NEAR(error_share, 1, 1e-9);
    const double error = found["light_map"]["choice"]["error"];
    EXPECT_NEAR(std::sqrt(error_sq), error, 0.2 * error) << "negative squares of surfaces count as none";
    EXPECT_NE(text_of(path("out/fit.md")).find("explanation.png"), std::string::npos);
    EXPECT_NE(ended.out.find("| surface |"), std::string::npos) << ended.out;
}

TEST_F(Fit, ExplainsWhatComesNearestToATargetOutOfReach) {
    const Json found = json_of({"--explain"}, "0.1%");
    EXPECT_FALSE(found["light_map"]["reached"].get<bool>());
    for (const Json& surface : found["explanation"])
        EXPECT_EQ(surface["blocks"]["kinds"].size(), 1u) << "one basis everywhere";
}

TEST_F(Fit, ByBytesIsTheSameAgainOnAnyNumberOfThreads) {
    ONLY_WHERE_OPTIMISED;
    const auto choices = [&](const char* threads) {
        Json found = json_of({"--least", "bytes", "--threads", threads});
        Json kept;
        for (const char* kind : {"light_map", "photon_map"})
            for (const char* key :
                 {"method", "hits", "error", "noise", "blur", "truncation", "bound", "bytes"})
                kept[kind][key] = found[kind]["choice"][key];
        return kept;
    };
    EXPECT_EQ(choices("1"), choices("2"));
}

TEST_F(Fit, SaysWhatIsOutOfReachAndEndsWell) {
    const Json found = json_of({}, "0.1%");
    for (const char* kind : {"light_map", "photon_map"}) {
        EXPECT_FALSE(found[kind]["reached"].get<bool>());
        EXPECT_NE(found[kind]["reason"].get<std::string>().find("0.1 %"), std::string::npos) << found[kind];
        EXPECT_FALSE(found[kind].contains("choice"));
        EXPECT_TRUE(found[kind].contains("nearest"));
    }
    const Ended ended = run(fit({}, "0.1%"));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_NE(ended.out.find("out of reach"), std::string::npos) << ended.out;
}

TEST_F(Fit, GrowsNoPilotForWhatCannotBeReached) {
    const Ended ended =
        run({"fit", cornell, "--target", "0.1%", "--pilot", "4e5", "--max-hits", "1e4", "--json"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json pilot = Json::parse(ended.out)["pilot"];
    EXPECT_LT(pilot["hits_of_each_half"], pilot["largest_allowed"]);
}

TEST_F(Fit, TakesAllOfThePilotForWhatAsksForIt) {
    ONLY_WHERE_OPTIMISED;
    for (const std::string largest : {"60000", "120000"}) {  // neither is the smallest times a power of four
        const Ended ended = run({"fit", cornell, "--target", "1%", "--pilot", largest, "--json"});
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_EQ(Json::parse(ended.out)["pilot"]["hits_of_each_half"], std::stod(largest));
    }
}

TEST_F(Fit, KeepsWithinBudgets) {
    const Json found = json_of({"--budget-bytes", "1000"});
    for (const char* kind : {"light_map", "photon_map"}) {
        EXPECT_FALSE(found[kind]["reached"].get<bool>());
        EXPECT_NE(found[kind]["reason"].get<std::string>().find("--budget-bytes"), std::string::npos);
    }
}

TEST_F(Fit, ListsTheGrid) {
    const Ended ended = run({"fit", "--list"});
    EXPECT_EQ(ended.exit_code, 0);
    std::istringstream lines(ended.out);
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) names.insert(line);
    EXPECT_TRUE(names.contains("shlm/L2/radiance/surface4/t65536/h0/half"));
    EXPECT_TRUE(names.contains("photonmap/compact/k64/epanechnikov"));
    EXPECT_GT(names.size(), 100u);
}

TEST_F(Fit, RefusesWhatMeansNothing) {
    expect_refusal({"fit", "--target", "5%"}, {"SCENE"});
    expect_refusal({"fit", cornell}, {"--target"});
    for (const char* value : {"5", "5%,0%", "0%", "100%", "-1%", "much%"})
        expect_refusal({"fit", cornell, "--target=" + std::string(value)}, {"--target"});
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--least", "money"}, "money"},
        {{"--least", "time,money"}, "money"},
        {{"--budget-bytes", "little"}, "--budget-bytes"},
        {{"--time", "soon"}, "--time"},
        {{"--budget-time", "soon"}, "--budget-time"},
        {{"--seeds", "0"}, "--seeds"},
        {{"--threads=-1"}, "--threads"},
        {{"--verify", path("none.exr")}, "none.exr"}};
    expect_refusal({"fit", cornell, "--target", "5%", "--max-hits", "0"}, {"--max-hits"});
    expect_refusal({"fit", cornell, "--target", "5%", "--pilot", "10"}, {"--pilot"});
    for (const auto& [more, fragment] : wrong) expect_refusal(fit(more), {fragment});
    expect_refusal({"fit", path("none.glb"), "--target", "5%"}, {"none.glb"});
    folder.write("file", "");
    expect_refusal(fit({"--out", path("file")}), {"--out", "file"});
}

TEST_F(Fit, OutOfTimeItAnswersWithWhatItKnows) {
    const Json found = json_of({"--time", "0.001s"}, "10%", "1e6");
    EXPECT_EQ(found["pilot"]["stopped"], "--time is over");
    EXPECT_LT(found["pilot"]["hits_of_each_half"], found["pilot"]["largest_allowed"]);
    for (const char* kind : {"light_map", "photon_map"}) EXPECT_TRUE(found[kind].contains("sure"));
}

TEST_F(Fit, InterruptedItAnswersOrLeavesNothing) {
    Child child = start({"fit", cornell, "--target", "0.1%", "--pilot", "1e9", "--out", path("out")});
    ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("out")); }));
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGINT); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_NE(ended.err.find("shlmbench: fit stopped: "), std::string::npos) << ended.err;
    const bool answered = ended.err.find("the last answer is what was known by then") != std::string::npos;
    using Files = std::set<std::string>;
    EXPECT_EQ(files_in(path("out")), answered ? Files({"fit.json", "fit.md", "models.json"}) : Files());
}

}  // namespace
