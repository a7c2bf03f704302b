// Says when a fit must stop: the user has interrupted it, or its time is over.
#pragma once

#include <limits>
#include <stdexcept>

#include "common/core/interrupt.h"
#include "common/core/stopwatch.h"

namespace bench::fit {

/// Ends the search, which then returns what it knows.
class Stopped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class StopRule {
  public:
    /// Starts the clock.
    explicit StopRule(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    [[nodiscard]] bool over() const { return common::interrupted() || clock_.seconds() > seconds_; }

    /// Throws Stopped, saying what ended it.
    void check() const {
        if (over()) throw Stopped(common::interrupted() ? "interrupted" : "--time is over");
    }

  private:
    common::Stopwatch clock_;
    double seconds_;
};

}  // namespace bench::fit
