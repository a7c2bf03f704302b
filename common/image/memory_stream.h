// An OpenEXR file in memory.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace common {

/// Stores what OpenEXR writes.
class MemoryStream : public Imf::OStream {
  public:
    explicit MemoryStream(const char* name) : Imf::OStream(name) {}

    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

}  // namespace common
