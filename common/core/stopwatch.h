// Wall time.
#pragma once

#include <chrono>
#include <utility>

namespace common {

class Stopwatch {
  public:
    /// Returns the seconds since construction or since the last lap.
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }

    /// Returns the same and starts the next lap.
    double lap() {
        const auto now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace common
