// Tests shlmbench study from the user's point of view: what it measures, keeps and continues with.
#include "common/image/image.h"
#include "common/reference/reference_image.h"
#include "tests/support/study_command.h"

namespace {

using namespace study_command;

// Tests of what it measures.

TEST_F(Study, HasARowForEachMethodSizeAndSeed) {
    const Json rows = rows_of(finished_study());
    std::set<Key> expected;
    for (const std::string& method : some_methods)
        for (const std::uint64_t hits : {1000, 2000})
            for (const std::uint64_t seed : {1, 2}) expected.emplace(method, hits, seed);
    EXPECT_EQ(keys_of(rows), expected);
    for (const Json& row : rows) {
        SCOPED_TRACE(row.dump());
        EXPECT_EQ(row["scene"], "cornell");
        EXPECT_EQ(row["fields"]["family"],
                  row["method"].get<std::string>().starts_with("shlm") ? "shlm" : "photonmap");
        EXPECT_EQ(row["style"]["colour"].get<std::string>().size(), 7u);
        EXPECT_GE(row["hits"], row["hits_asked"]);
        EXPECT_GT(row["photons_emitted"], 0);
        for (const char* name : {"trace_seconds", "insert_seconds", "build_seconds", "gather_seconds"})
            EXPECT_GE(row[name].get<double>(), 0) << name;
        EXPECT_GT(row["prepare_seconds"], 0);
        EXPECT_GT(row["prepare_bytes"], 0);
        EXPECT_GT(row["bytes"], 0);
        EXPECT_GT(row["insert_bytes"], 0);
        EXPECT_EQ(row["hits_rejected"], 0);
        const std::string method = row["method"];
        const bool is_light_map = method.starts_with("shlm");
        EXPECT_EQ(row["texels"], !is_light_map ? 0 : method.ends_with("t1024") ? 1024 : 256);
        ASSERT_EQ(row.contains("clamped_share"), is_light_map);
        if (is_light_map) {
            EXPECT_GE(row["clamped_share"], 0);
            EXPECT_LT(row["clamped_share"], 1e-3);
        }
        ASSERT_EQ(row.contains("flip"), row["seed"] == 1);
        if (row["seed"] == 1) {
            EXPECT_GT(row["flip"], 0);
            EXPECT_LT(row["flip"], 1);
        }
        EXPECT_FALSE(row.contains("skipped"));
    }
    for (const char* key : {"machine", "instruction_set", "commit", "compiler", "flags", "libraries", "built",
                            "date", "threads", "settings", "lights_and_camera"})
        EXPECT_TRUE(table_of(finished_study())["context"].contains(key)) << key;
    const std::string report = text_of(finished_study() / "report.md");
    for (const std::string& method : some_methods)
        EXPECT_NE(report.find(method), std::string::npos) << method;
}

TEST_F(Study, GivesAllMethodsTheSamePhotonsAndEachSeedItsOwn) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::set<std::pair<std::uint64_t, std::uint64_t>>>
        traced;
    for (const Json& row : rows_of(finished_study()))
        traced[{row["hits_asked"], row["seed"]}].emplace(row["hits"], row["photons_emitted"]);
    ASSERT_EQ(traced.size(), 4u);
    for (const auto& [run, traces] : traced) EXPECT_EQ(traces.size(), 1u);
    EXPECT_NE(traced.at({2000, 1}), traced.at({2000, 2}));
}

TEST_F(Study, AnswersForThePointsOfTheReference) {
    const auto reference = common::reference::read_reference(references() / "cornell.exr");
    const fs::path raw = finished_study() / "raw/cornell";
    const auto pixel = values_of<std::uint32_t>(raw / "pixel.u32");
    const auto truth = values_of<float>(raw / "reference.f32"),
               variance = values_of<float>(raw / "variance.f32");
    ASSERT_EQ(pixel.size(), std::size_t{width} * height) << "the room is closed";
    ASSERT_EQ(truth.size(), 3 * pixel.size());
    ASSERT_EQ(variance.size(), 3 * pixel.size());
    for (std::size_t i = 0; i < pixel.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto& point = reference.pixel.at(pixel[i]);
            EXPECT_EQ(truth[3 * i + c], point.irradiance[static_cast<int>(c)]);
            EXPECT_EQ(variance[3 * i + c], point.variance[static_cast<int>(c)]);
        }
    const auto tilt = values_of<float>(raw / "tilt.f32");
    ASSERT_EQ(tilt.size(), pixel.size());
    for (const float degrees : tilt) EXPECT_LT(degrees, 0.1f) << "cornell has no normal maps";

    const Json scene = table_of(finished_study())["scenes"]["cornell"];
    EXPECT_EQ(scene["points"], pixel.size());
    EXPECT_EQ(scene["width"], width);
    EXPECT_EQ(scene["height"], height);
    EXPECT_EQ(scene["raw"], "raw/cornell");
    EXPECT_EQ(scene["fingerprint"], reference.notes.at("shlmbench:fingerprint"));
    const double error = std::stod(reference.notes.at("shlmbench:relative_error"));
    EXPECT_NEAR(scene["reference_error"].get<double>(), error, 1e-3 * error);
    for (const Json& row : rows_of(finished_study())) {
        const fs::path answers = answers_of(finished_study(), row);
        EXPECT_EQ(values_of<float>(answers).size(), truth.size());
        if (row["seed"] != 1) continue;
        for (const char* ending : {".png", "-flip.png"}) {
            const std::string name = std::to_string(row["hits_asked"].get<int>()) + ending;
            const common::Image picture = common::read_image(answers.parent_path() / name);
            EXPECT_EQ(picture.width, width);
            EXPECT_EQ(picture.height, height);
        }
    }
}

TEST_F(Study, AnswersAsRenderDoes) {
    for (const Json& row : rows_of(finished_study())) {
        if (row["hits_asked"] != 2000 || row["seed"] != 2) continue;
        SCOPED_TRACE(row.dump());
        const auto answers = values_of<float>(answers_of(finished_study(), row));
        const auto text = [&](const char* name) { return std::to_string(row[name].get<int>()); };
        const Ended ended =
            run_command({"render", cornell, "--method", row["method"], "--texels", "256", "--hits",
                         text("hits_asked"), "--seed", text("seed"), "--width", std::to_string(width),
                         "--height", std::to_string(height), "--out", path("image.exr")},
                        said);
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
        const common::Image image = common::read_image(path("image.exr"));
        ASSERT_EQ(answers.size(), 3 * image.pixel_count());
        const std::size_t red = *image.find_channel("irradiance.R");
        for (std::size_t p = 0; p < image.pixel_count(); ++p)
            for (std::size_t c = 0; c < 3; ++c)  // half floats have 11 digits
                ASSERT_NEAR(image.at(p, red + c), answers[3 * p + c], answers[3 * p + c] / 2048 + 1e-7);
    }
}

// Tests of its repeatability.

TEST_F(Study, IsTheSameAgainAndOnAnyNumberOfThreads) {
    const Contents raw = contents_of(finished_study() / "raw");
    EXPECT_EQ(raw.size(), 5 + some_methods.size() * 2 * 4) << "of the scene; of each method, size and seed";
    for (const char* threads : {"1", "2"}) {
        SCOPED_TRACE(std::string(threads) + " threads");
        expect_same_rows(study({.out = path(threads), .more = {"--threads", threads}}),
                         rows_of(finished_study()));
        EXPECT_TRUE(contents_of(path(threads) + "/raw") == raw) << threads << " threads";
    }
}

TEST_F(Study, RunAgainMeasuresNothing) {
    fs::copy(finished_study(), path("out"), fs::copy_options::recursive);
    const Contents before = contents_of(path("out/raw"));
    const std::string table = text_of(path("out/study.json"));
    const auto written = fs::last_write_time(path("out/raw/cornell/shlm-L2-radiance-own/2000-2.f32"));
    const Ended ended = run({.out = path("out")});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "study: 16 rows in " + path("out/study.json") +
                             " are of this build and settings and are kept\n");
    EXPECT_EQ(text_of(path("out/study.json")), table);
    EXPECT_TRUE(contents_of(path("out/raw")) == before);
    EXPECT_EQ(fs::last_write_time(path("out/raw/cornell/shlm-L2-radiance-own/2000-2.f32")), written);
}

TEST_F(Study, ExtendedMeasuresOnlyWhatIsMissing) {
    const Words fewer = {"shlm/L2/radiance/own", "photonmap/flann/k50/disc"};
    const Json before = study({.out = path("out"), .methods = fewer, .hits = "2000", .seeds = "1"});
    ASSERT_EQ(before.size(), 2u);
    const std::string old_answers = path("out/raw/cornell/shlm-L2-radiance-own/2000-1.f32");
    const auto written = fs::last_write_time(old_answers);

    const Ended ended = run({.out = path("out")});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_TRUE(ended.err.starts_with("study: 2 rows in ")) << ended.err;
    const Json after = rows_of(path("out"));
    ASSERT_EQ(after.size(), 16u);
    EXPECT_EQ(after[0], before[0]) << "times included";
    EXPECT_EQ(after[1], before[1]);
    EXPECT_EQ(fs::last_write_time(old_answers), written);
    // Answers are those of a single study, whichever methods share the trace and the store.
    expect_same_rows(after, rows_of(finished_study()));
    EXPECT_TRUE(contents_of(path("out/raw")) == contents_of(finished_study() / "raw"));
}

TEST_F(Study, MeasuresInTurnWhatDoesNotFitIntoMemoryTogether) {
    Request request = {.out = path("out"), .hits = "1000", .seeds = "1"};
    request.methods = {"shlm/L2/radiance/own/t131072", "shlm/L2/normalised/own/t131072",
                       "shlm/F1/radiance/own/t131072", "photonmap/compact/k50/disc"};
    const auto measured = [&](const std::string& folder, const std::string& memory) {
        request.out = path(folder);
        request.more = {"--max-memory", memory};
        std::map<std::string, std::vector<float>> answers;
        for (const Json& row : study(request)) {
            EXPECT_FALSE(row.contains("skipped")) << row;
            answers[row["method"]] = values_of<float>(answers_of(request.out, row));
        }
        EXPECT_EQ(answers.size(), 4u);
        return answers;
    };
    EXPECT_EQ(measured("apart", "150MiB"), measured("together", "4GiB"));
}

TEST_F(Study, SaysWhatDoesNotFitAndMeasuresItWhenItDoes) {
    Request request = {.out = path("out"), .hits = "1000", .seeds = "1", .more = {"--max-memory", "150MiB"}};
    request.methods = {"shlm/L2/radiance/own", "shlm/L2/radiance/own/t200000"};
    const Json rows = study(request);
    EXPECT_EQ(keys_of(rows), (std::set<Key>{{request.methods[0], 1000, 1}, {request.methods[1], 1000, 1}}));
    for (const Json& row : rows) {
        ASSERT_EQ(row.contains("skipped"), row["method"] == request.methods[1]) << row;
        if (!row.contains("skipped")) continue;
        EXPECT_TRUE(row["skipped"].get<std::string>().starts_with("needs 0.2 GiB")) << row;
        EXPECT_EQ(row["texels"], 200'000);
        EXPECT_FALSE(row.contains("answers"));
        EXPECT_FALSE(row.contains("bytes"));
    }
    EXPECT_FALSE(fs::exists(path("out/raw/cornell/shlm-L2-radiance-own-t200000")));
    EXPECT_TRUE(fs::exists(path("out/report.md")));

    request.more = {"--max-memory", "2GiB"};
    const Json measured = study(request);
    EXPECT_EQ(keys_of(measured), keys_of(rows));
    for (const Json& row : measured) EXPECT_FALSE(row.contains("skipped")) << row;
    EXPECT_EQ(measured[0], rows[1]) << "kept";
}

TEST_F(Study, SaysWhyALightMapIsNotToBeHad) {
    const std::string scene = gltf_text::one_triangle().write(folder).string();
    make_reference("scene.exr", {"--width", "16", "--height", "9", "--sky", "1,1,1"}, scene);
    const Json rows = study({.out = path("out"),
                             .methods = {"shlm/L2/radiance/own/uv", "shlm/L2/radiance/own", "photonmap"},
                             .hits = "500",
                             .seeds = "1",
                             .more = {"--sky", "1,1,1"},
                             .references = folder.path().string(),
                             .scene = scene});
    ASSERT_EQ(rows.size(), 3u);
    for (const Json& row : rows) {
        const bool by_uv = row["method"] == "shlm/L2/radiance/own/uv";
        ASSERT_EQ(row.contains("skipped"), by_uv) << row;
        if (by_uv) {
            EXPECT_NE(row["skipped"].get<std::string>().find("TEXCOORD_1"), std::string::npos) << row;
        }
    }
}

}  // namespace
