// After kill -9 at any moment, at most the work since the last checkpoint is lost, but never the file.
#include <fmt/format.h>

#include <random>

#include "tests/support/command.h"
#include "tests/support/statistics.h"

namespace {

using namespace command;
using child_process::text_of;
using Clock = std::chrono::steady_clock;

class Kill : public Command {
  protected:
    /// Traces with checkpoints so frequent that about half of all moments are within one.
    [[nodiscard]] Words trace(const std::string& option, const std::string& file, int threads) const {
        const std::uint64_t photons = tests::count_for(1'500'000, 200'000);
        return {"trace",    cornell,    "--photons", std::to_string(photons),
                "--texels", "10000",    "--every",   "0.01s",
                option,     path(file), "--threads", std::to_string(threads)};
    }
};

TEST_F(Kill, LeavesAFileThatGoesOnToTheSameMap) {
    const int kills = static_cast<int>(tests::count_for(20, 5));
    constexpr unsigned seed = 1;
    const auto start_of_run = Clock::now();
    expect_success(trace("--checkpoint", "whole.exr", 2));
    const std::chrono::duration<double> duration = Clock::now() - start_of_run;
    const std::string whole = text_of(path("whole.exr"));

    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    int alive = 0, with_file = 0;
    for (int i = 0; i < kills; ++i) {
        // Every other kill comes soon after the first checkpoint, however fast the machine is.
        const bool after_checkpoint = i % 2 == 0;
        const auto moment = duration * part(random) * (after_checkpoint ? 0.2 : 1);
        SCOPED_TRACE(fmt::format("kill {} after {:.3f} s, seed {}", i, moment.count(), seed));
        fs::remove(path("map.exr"));
        Child child = start(trace("--checkpoint", "map.exr", 2));
        if (after_checkpoint) {
            ASSERT_TRUE(child_process::wait_until([&] { return fs::exists(path("map.exr")); }));
        }
        std::this_thread::sleep_for(moment);
        child.send(SIGKILL);
        alive += child.wait().exit_code == -1;
        const bool has_file = fs::exists(path("map.exr"));
        with_file += has_file;
        const Ended ended = run(trace(has_file ? "--resume" : "--checkpoint", "map.exr", 1 + i % 2));
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
        ASSERT_TRUE(text_of(path("map.exr")) == whole) << (has_file ? "resumed" : "begun anew");
        EXPECT_FALSE(fs::exists(path("map.exr.part")));
    }
    EXPECT_GT(alive, kills / 4) << "most kills came too late";
    EXPECT_GT(with_file, kills / 4) << "most kills came before the first checkpoint";
}

}  // namespace
