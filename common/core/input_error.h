// The exception for all errors that the user can correct: a bad file, option or path.
#pragma once

#include <stdexcept>

namespace common {

/// Thrown with a message of one line; the command prints it on stderr and exits with code 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace common
