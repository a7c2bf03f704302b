// A lock that lets only one process at a time write the output file of long work.
#pragma once

#include <filesystem>
#include <string>

namespace common {

/// Holds the lock of `file` as long as it lives. The lock is a system lock (flock) on an empty file
/// FILE.lock, which the destructor removes. A killed process leaves FILE.lock behind, but not locked. On file
/// systems without locks nothing is locked.
class OutputLock {
  public:
    /// Throws InputError, naming `option`, if another process holds the lock.
    OutputLock(const std::string& option, const std::filesystem::path& file);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace common
