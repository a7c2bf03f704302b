// Runs shlmbench study in a small form, and reads its files.
#pragma once

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "tests/support/command.h"

namespace study_command {

using namespace command;
using child_process::text_of;
using Json = nlohmann::json;

/// A method of every kind; the first two share a store.
inline const Words some_methods = {"shlm/L2/radiance/knn4", "shlm/L2/radiance/own",
                                   "shlm/L0/normalised/bilinear/t1024", "photonmap/flann/k50/disc"};

inline constexpr int width = 16, height = 9;

/// Returns a folder with cornell.exr, shared by all tests, since making it takes longer than most of them.
inline const fs::path& references() {
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

inline std::string comma_separated(const Words& words) {
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

/// The command line of a study.
struct Request {
    std::string out;
    Words methods = some_methods;
    std::string hits = "1000,2000", seeds = "2", texels = "256";
    Words more = {};
    std::string references = "";  ///< empty: references()
    std::string scene = cornell;
};

inline Words words_of(const Request& request) {
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

/// Returns the folder of a finished study of the default request, shared by all tests, which must not change
/// it.
inline const fs::path& finished_study() {
    static const TemporaryDirectory folder;
    static const bool made = [] {
        const TemporaryDirectory said;
        return run_command(words_of({.out = folder.path().string()}), said).exit_code == 0;
    }();
    EXPECT_TRUE(made);
    return folder.path();
}

inline Json table_of(const fs::path& study) {
    return Json::parse(text_of(study / "study.json"));
}

inline Json rows_of(const fs::path& study) {
    return table_of(study)["rows"];
}

inline fs::path answers_of(const fs::path& study, const Json& row) {
    return study / row["answers"].get<std::string>();
}

using Contents = std::map<std::string, std::string>;

/// Returns all files below `folder` with their contents.
inline Contents contents_of(const fs::path& folder) {
    Contents contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            contents[fs::relative(entry.path(), folder).string()] = text_of(entry.path());
    return contents;
}

class Study : public Command {
  protected:
    [[nodiscard]] Ended run(const Request& request) const { return run_command(words_of(request), said); }

    /// Runs a whole study and returns its rows.
    [[nodiscard]] Json study(const Request& request) const {
        const Ended ended = run(request);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return rows_of(request.out);
    }

    /// Expects exit code 2, one line that contains all of `fragments`, and every file unchanged.
    void expect_refusal(const Request& request, const Words& fragments) const {
        const Words words = words_of(request);
        SCOPED_TRACE(testing::PrintToString(words));
        const Contents before = contents_of(folder.path());
        expect_refused(run_command(words, said), fragments);
        EXPECT_TRUE(contents_of(folder.path()) == before) << "a file has changed";
    }

    /// Makes a reference other than references().
    void make_reference(const std::string& name, const Words& more,
                        const std::string& scene = cornell) const {
        Words words = {"reference", scene, "--out", path(name), "--spp", "64"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = run_command(words, said);
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
    }
};

using Key = std::tuple<std::string, std::uint64_t, std::uint64_t>;

/// Returns method, hits asked for and seed.
inline Key key_of(const Json& row) {
    return {row["method"], row["hits_asked"], row["seed"]};
}

inline std::set<Key> keys_of(const Json& rows) {
    std::set<Key> keys;
    for (const Json& row : rows) EXPECT_TRUE(keys.insert(key_of(row)).second) << row;
    return keys;
}

/// Returns the rows by method, size and seed.
inline std::map<Key, Json> by_key(const Json& rows) {
    std::map<Key, Json> sorted;
    for (const Json& row : rows) sorted[key_of(row)] = row;
    EXPECT_EQ(sorted.size(), rows.size());
    return sorted;
}

/// Expects equal rows, except for times and, within a tolerance, the bytes of an index. These are measured at
/// the allocator, where threads that start meanwhile may take a page or two.
inline void expect_same_rows(const Json& actual, const Json& expected) {
    std::map<Key, Json> a = by_key(actual), b = by_key(expected);
    ASSERT_EQ(a.size(), b.size());
    for (auto& [key, row] : a) {
        ASSERT_TRUE(b.contains(key)) << row;
        Json& other = b[key];
        for (const char* name : {"bytes", "insert_bytes"}) {
            const double bytes = other[name];
            EXPECT_NEAR(row[name].get<double>(), bytes, 0.02 * bytes + 8192) << name << " of " << row;
        }
        for (const char* name : {"prepare_seconds", "trace_seconds", "insert_seconds", "build_seconds",
                                 "gather_seconds", "bytes", "insert_bytes"}) {
            EXPECT_EQ(row.erase(name), 1u) << name;
            EXPECT_EQ(other.erase(name), 1u) << name;
        }
        EXPECT_EQ(row, other);
    }
}

}  // namespace study_command
