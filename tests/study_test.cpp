// shlmbench study as its user meets it: what it measures, keeps, goes on with and refuses.
#include <cmath>
#include <map>

#include "common/image/image.h"
#include "common/reference/reference_image.h"
#include "tests/command.h"

namespace {

using namespace command;
using child_process::text_of;
using Json = nlohmann::json;

/// A method of every kind; the first two share a store.
const Words some_methods = {"shlm/L2/radiance/knn4", "shlm/L2/radiance/own",
                            "shlm/L0/normalised/bilinear/t1024", "photonmap/flann/k50/disc"};

constexpr int width = 16, height = 9;

/// A folder with cornell.exr, the same for all tests: its making takes longer than most of them.
const fs::path& references() {
    static const TemporaryDirectory folder;
    static const bool made = [] {
        const TemporaryDirectory said;
        return run_command(
                   {"reference", cornell, "--out", (folder.path() / "cornell.exr").string(), "--width",
                    std::to_string(width), "--height", std::to_string(height), "--spp", "64"},
                   said)
                   .exit_code == 0;
    }();
    EXPECT_TRUE(made);
    return folder.path();
}

std::string comma_separated(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
    return text;
}

template <class T>
std::vector<T> values_of(const fs::path& file) {
    const std::string bytes = text_of(file);
    std::vector<T> values(bytes.size() / sizeof(T));
    EXPECT_EQ(values.size() * sizeof(T), bytes.size()) << file;
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// What a study's command line says.
struct Request {
    std::string out;
    Words methods = some_methods;
    std::string hits = "1000,2000", seeds = "2", texels = "256";
    Words more = {};
    std::string references = "";  ///< empty: references()
    std::string scene = cornell;
};

Words words_of(const Request& request) {
    Words words = {"study",        request.scene,
                   "--methods",    comma_separated(request.methods),
                   "--hits",       request.hits,
                   "--seeds",      request.seeds,
                   "--texels",     request.texels,
                   "--out",        request.out,
                   "--references", request.references.empty() ? references().string() : request.references};
    words.insert(words.end(), request.more.begin(), request.more.end());
    return words;
}

/// The folder of a study of the default request, finished, the same for all tests: none may change it.
const fs::path& finished_study() {
    static const TemporaryDirectory folder;
    static const bool made = [] {
        const TemporaryDirectory said;
        return run_command(words_of({.out = folder.path().string()}), said).exit_code == 0;
    }();
    EXPECT_TRUE(made);
    return folder.path();
}

Json table_of(const fs::path& study) {
    return Json::parse(text_of(study / "study.json"));
}

Json rows_of(const fs::path& study) {
    return table_of(study)["rows"];
}

fs::path answers_of(const fs::path& study, const Json& row) {
    return study / row["answers"].get<std::string>();
}

using Contents = std::map<std::string, std::string>;

/// All files below `folder` with what is in them.
Contents contents_of(const fs::path& folder) {
    Contents contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            contents[fs::relative(entry.path(), folder).string()] = text_of(entry.path());
    return contents;
}

class Study : public testing::Test {
  protected:
    TemporaryDirectory said;    ///< what the command prints
    TemporaryDirectory folder;  ///< what it reads and writes

    [[nodiscard]] std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    [[nodiscard]] Ended run(const Request& request) const { return run_command(words_of(request), said); }

    /// Runs a whole study; returns its rows.
    [[nodiscard]] Json study(const Request& request) const {
        const Ended ended = run(request);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return rows_of(request.out);
    }

    /// Exit code 2, one line that has all of `fragments`, and every file as it was.
    void expect_refusal(const Request& request, const Words& fragments) const {
        const Words words = words_of(request);
        SCOPED_TRACE(testing::PrintToString(words));
        const Contents before = contents_of(folder.path());
        expect_refused(run_command(words, said), fragments);
        EXPECT_TRUE(contents_of(folder.path()) == before) << "a file has changed";
    }

    /// Makes another reference than references().
    void make_reference(const std::string& name, const Words& more,
                        const std::string& scene = cornell) const {
        Words words = {"reference", scene, "--out", path(name), "--spp", "64"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = run_command(words, said);
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
    }
};

using Key = std::tuple<std::string, std::uint64_t, std::uint64_t>;

/// Method, hits asked for and seed.
Key key_of(const Json& row) {
    return {row["method"], row["hits_asked"], row["seed"]};
}

std::set<Key> keys_of(const Json& rows) {
    std::set<Key> keys;
    for (const Json& row : rows) EXPECT_TRUE(keys.insert(key_of(row)).second) << row;
    return keys;
}

/// Rows by method, size and seed.
std::map<Key, Json> by_key(const Json& rows) {
    std::map<Key, Json> sorted;
    for (const Json& row : rows) sorted[key_of(row)] = row;
    EXPECT_EQ(sorted.size(), rows.size());
    return sorted;
}

/// The same but for what depends on the moment: times, and the bytes of an index, which are measured at the
/// allocator.
void expect_same_rows(const Json& actual, const Json& expected) {
    std::map<Key, Json> a = by_key(actual), b = by_key(expected);
    ASSERT_EQ(a.size(), b.size());
    for (auto& [key, row] : a) {
        ASSERT_TRUE(b.contains(key)) << row;
        Json& other = b[key];
        for (const char* name : {"bytes", "insert_bytes"}) {
            const double bytes = other[name];
            EXPECT_NEAR(row[name].get<double>(), bytes, 0.02 * bytes) << name << " of " << row;
        }
        for (const char* name : {"trace_seconds", "insert_seconds", "build_seconds", "gather_seconds",
                                 "bytes", "insert_bytes"}) {
            EXPECT_EQ(row.erase(name), 1u) << name;
            EXPECT_EQ(other.erase(name), 1u) << name;
        }
        EXPECT_EQ(row, other);
    }
}

// What it measures.

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
        EXPECT_GE(row["hits"], row["hits_asked"]);
        EXPECT_GT(row["photons_emitted"], 0);
        for (const char* name : {"trace_seconds", "insert_seconds", "build_seconds", "gather_seconds"})
            EXPECT_GE(row[name].get<double>(), 0) << name;
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
    for (const char* key : {"machine", "commit", "compiler", "flags", "libraries", "built", "date", "threads",
                            "settings", "lights_and_camera"})
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

// The same again.

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
    // Whatever shares the trace and the store, answers are those of a study in one go.
    expect_same_rows(after, rows_of(finished_study()));
    EXPECT_TRUE(contents_of(path("out/raw")) == contents_of(finished_study() / "raw"));
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

// What it refuses.

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
    // Another camera sees other points.
    expect_refusal(with({"--camera", "0,1,1,0,1,0,60"}), fragments);
    // A table of another build.
    Json table = table_of(path("out"));
    table["context"]["built"] = "1970-01-01T00:00:00Z";
    std::ofstream(path("out/study.json")) << table.dump();
    expect_refusal(request, fragments);
    // Told to, it begins again.
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
                           "--height", "9", "--out", path("references/cornell.exr")},
                          said)
                  .exit_code,
              0);
    expect_refusal(request, {"references/cornell.exr", "is not a reference"});
}

TEST_F(Study, RefusesAReferenceThatLacksLightWhichPhotonsFind) {
    fs::create_directories(path("out"));
    fs::create_directories(path("references"));
    const std::string caustic = build_folder + "/scenes/caustic.glb";
    const Words sun = {"--sun", "0,1,0,1,1,1"};  // no path to it leads through the glass ball
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
    // The reference of one scene under the name of another.
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
    // As many seeds as there may be: the signal comes long before the last.
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
    // It has measured what it would have measured without the signal.
    request.out = path("whole");
    expect_same_rows(after, study(request));
    EXPECT_TRUE(contents_of(path("out/raw")) == contents_of(path("whole/raw")));
}

TEST_F(Study, InterruptedWhileTracingLeavesNoUnfinishedRow) {
    // The second size takes longer than any signal.
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
