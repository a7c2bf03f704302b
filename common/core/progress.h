// Progress of long work: a bar with rate and remaining time on a terminal, elsewhere a plain line now and
// then.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace common {

/// Writes to stderr. Draws at most ten times a second on a terminal, at most every 10 seconds elsewhere.
class Progress {
  public:
    /// `unit` names what is counted: "hits", "photons".
    Progress(std::string what, std::string unit, std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Changes the total, for work whose amount becomes known only on the way.
    void set_total(std::uint64_t total);

    void show(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_, unit_;
    std::uint64_t total_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_, last_;
};

}  // namespace common
