// Tests files that once made a program crash, hang or report nonsense, and the initial inputs of fuzzing.
#include <gtest/gtest.h>

#include "tests/fuzz/broken_file.h"

namespace {

namespace fs = std::filesystem;

const fs::path folder = SHLMBENCH_FUZZ_FOLDER;

template <class Check>
void for_each_file(const fs::path& in, Check check) {
    if (!fs::exists(in)) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(in)) {
        SCOPED_TRACE(entry.path().filename().string());
        check(entry.path());
    }
}

TEST(BrokenFiles, FindingsAreRefusedInOneLineOrSound) {
    for_each_file(folder / "findings" / "scene", [](const fs::path& file) {
        EXPECT_EQ(fuzz::trouble_of_scene(file).find('\n'), std::string::npos);
    });
    for_each_file(folder / "findings" / "checkpoint", [](const fs::path& file) {
        EXPECT_EQ(fuzz::trouble_of_checkpoint(file).find('\n'), std::string::npos);
    });
}

TEST(BrokenFiles, FuzzingBeginsWithSoundFiles) {
    int seeds = 0;
    for_each_file(folder / "seeds" / "scene", [&](const fs::path& file) {
        ++seeds;
        EXPECT_EQ(fuzz::trouble_of_scene(file), "");
    });
    for_each_file(folder / "seeds" / "checkpoint", [&](const fs::path& file) {
        ++seeds;
        EXPECT_EQ(fuzz::trouble_of_checkpoint(file), "");
    });
    EXPECT_GE(seeds, 3);
}

}  // namespace
