// The one exception for what the user can put right: a bad file, option or path.
#pragma once

#include <stdexcept>

namespace common {

/// Thrown with one clear line; the command prints it on stderr and exits with code 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace common
