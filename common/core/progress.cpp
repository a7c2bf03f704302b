#include "common/core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "common/core/standard_streams.h"

namespace common {

Progress::Progress(std::string what, std::string unit, std::uint64_t total)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      total_(std::max<std::uint64_t>(total, 1)),
      terminal_(isatty(STDERR_FILENO)),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::set_total(std::uint64_t total) {
    total_ = std::max<std::uint64_t>(total, 1);
}

void Progress::show(std::uint64_t done) {
    using Seconds = std::chrono::duration<double>;
    const auto now = Clock::now();
    if (Seconds(now - last_).count() < (terminal_ ? 0.1 : 10.0)) return;
    last_ = now;
    const double elapsed = Seconds(now - start_).count();
    const double fraction = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
    const double left = fraction > 0 ? elapsed / fraction - elapsed : 0;
    const std::string line =
        fmt::format("{} {:3.0f} %, {:.3g} {}, {:.3g} {}/s, {:.0f} s left", what_, 100 * fraction,
                    static_cast<double>(done), unit_, static_cast<double>(done) / elapsed, unit_, left);
    if (terminal_) {
        constexpr std::size_t width = 24;
        const auto filled = static_cast<std::size_t>(fraction * width);
        // A failed write is ignored: the work is worth more than its progress bar.
        std::fputs(fmt::format("\r\033[K[{}{}] {}", std::string(filled, '#'),
                               std::string(width - filled, '.'), one_line(line))
                       .c_str(),
                   stderr);
    } else {
        say(line);
    }
    drawn_ = true;
}

}  // namespace common
