// One writer at a time for a file that long work goes into.
#pragma once

#include <filesystem>
#include <string>

namespace common {

/// While it lives no other process gets the lock of `file`. It is the system's, on an empty file FILE.lock
/// that goes with it: a process that is killed leaves that file, and nobody has to wait for it. File systems
/// that know no locks give none.
class OutputLock {
  public:
    /// Throws InputError, naming `option`, where another process has it.
    OutputLock(const std::string& option, const std::filesystem::path& file);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace common
