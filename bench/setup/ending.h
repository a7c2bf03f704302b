// How a command may end other than well or by bad input (common/core/input_error.h).
#pragma once

#include <stdexcept>

namespace bench {

/// The user ended long work; the message says what became of it. The command exits with 130.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// All went well, and a result is beyond the bound that the user set. The command exits with 1.
class BoundExceeded : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace bench
