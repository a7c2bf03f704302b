// Runs the command as a user does, in temporary folders.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/support/child_process.h"
#include "tests/support/gltf_text.h"

namespace command {

namespace fs = std::filesystem;

using child_process::Child;
using child_process::Ended;
using gltf_text::GltfFile;
using gltf_text::TemporaryDirectory;
using Words = std::vector<std::string>;

inline const std::string build_folder = SHLMBENCH_BINARY_DIR;
inline const std::string cornell = build_folder + "/scenes/cornell.glb";

/// Returns the names of all files and folders below `folder`.
inline std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        names.insert(entry.path().lexically_relative(folder).string());
    return names;
}

/// Removes progress lines, which short work may show on a busy machine; they are no complaints.
inline std::string without_progress(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.ends_with(" left")) kept += line + '\n';
    return kept;
}

inline Ended run_command(const Words& words, const TemporaryDirectory& said) {
    Ended ended = Child(build_folder + "/shlmbench", words, said.path()).wait();
    ended.err = without_progress(ended.err);
    return ended;
}

/// Expects the end of a user's mistake: exit code 2, and one line that contains all of `fragments`.
inline void expect_refused(const Ended& ended, const Words& fragments) {
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_TRUE(ended.err.starts_with("shlmbench: ")) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
    for (const std::string& fragment : fragments)
        EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << "\n" << ended.err;
}

class Command : public testing::Test {
  protected:
    TemporaryDirectory said;    ///< what the command prints
    TemporaryDirectory folder;  ///< what it reads and writes

    [[nodiscard]] std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    [[nodiscard]] Child start(const Words& words) const {
        return Child(build_folder + "/shlmbench", words, said.path());
    }

    [[nodiscard]] Ended run(const Words& words) const { return run_command(words, said); }

    /// Returns the path of the file.
    [[nodiscard]] std::string write(const GltfFile& scene) const { return scene.write(folder).string(); }

    /// Returns the arguments of a small render, followed by `more`.
    [[nodiscard]] Words render(const std::string& scene, const std::string& method,
                               const Words& more = {}) const {
        Words words = {"render",          scene,     "--method", method,     "--hits", "2000", "--out",
                       path("image.exr"), "--width", "32",       "--height", "18"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    /// Expects a user's mistake: exit code 2, one line that contains all of `fragments`, and no new files.
    void expect_refusal(const Words& words, const Words& fragments) const {
        SCOPED_TRACE(testing::PrintToString(words));
        const auto before = files_in(folder.path());
        expect_refused(run(words), fragments);
        EXPECT_EQ(files_in(folder.path()), before);
    }

    void expect_success(const Words& words) const {
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << testing::PrintToString(words);
        EXPECT_EQ(ended.err, "");
    }
};

/// A subcommand that writes into a folder, which it makes.
class FolderCommand : public Command {
  protected:
    explicit FolderCommand(std::string name) : name_(std::move(name)) {}

    [[nodiscard]] fs::path out() const { return folder.path() / "new" / name_; }

    [[nodiscard]] Ended run(const Words& more) const {
        Words words = {name_};
        words.insert(words.end(), more.begin(), more.end());
        return Command::run(words);
    }

    void expect_refusal(const Words& words, const std::string& fragment) const {
        expect_refused(run(words), {fragment});
        EXPECT_FALSE(fs::exists(out()));
    }

  private:
    std::string name_;
};

}  // namespace command
