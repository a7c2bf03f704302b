// How a command may end, apart from success and bad input (common/core/input_error.h).
#pragma once

#include <stdexcept>

namespace bench {

/// The user interrupted long work; the message says what became of it. The command exits with 130.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A result exceeds the bound that the user set, though nothing failed. The command exits with 1.
class BoundExceeded : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace bench
