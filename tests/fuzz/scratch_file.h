// Writes a fuzzer's bytes to a file, as the tested code reads files.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace fuzz {

/// A file of this process, in memory if the system supports that; removed with the object.
class ScratchFile {
  public:
    ScratchFile(const std::string& extension, std::span<const std::uint8_t> bytes)
        : path_(folder() / ("shlmbench-fuzz-" + std::to_string(getpid()) + extension)) {
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    static std::filesystem::path folder() {
        return std::filesystem::is_directory("/dev/shm") ? "/dev/shm"
                                                         : std::filesystem::temp_directory_path();
    }

    std::filesystem::path path_;
};

}  // namespace fuzz
