// An array that grows without moving.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace common {

/// An array whose elements keep their addresses while it grows and when it is moved; growing copies nothing.
/// It reserves address space for `max_size` elements up front (mmap(2)), and takes memory from the system
/// only as elements are written.
template <class T>
requires std::is_trivially_destructible_v<T>
class StableArray {
  public:
    /// Pages of 2 MiB are fewer and faster. Pages of 4 KiB save memory if the array is filled at many places
    /// at once.
    enum class Pages { large, small };

    /// Throws std::bad_alloc where the system does not give that much address space.
    explicit StableArray(std::size_t max_size, Pages pages = Pages::large) : max_size_(max_size) {
        void* memory = mmap(nullptr, reserved_bytes(), PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        data_ = static_cast<T*>(memory);
        // Some systems refuse large pages, which costs only speed.
        madvise(memory, reserved_bytes(), pages == Pages::large ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
    }

    StableArray(StableArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)),
          max_size_(std::exchange(other.max_size_, 0)) {}
    StableArray& operator=(StableArray&&) = delete;

    ~StableArray() {
        if (data_) munmap(data_, reserved_bytes());
    }

    /// Appends `count` elements and returns them; they are zero until written. Throws std::bad_alloc if the
    /// size would exceed max_size.
    std::span<T> grow(std::size_t count) {
        if (count > max_size_ - size_) throw std::bad_alloc();
        size_ += count;
        return {data_ + size_ - count, count};
    }

    /// Returns the memory of elements [first, last) to the system, in whole blocks of `granularity` bytes.
    /// None of these elements may be read afterwards.
    void release(std::size_t first, std::size_t last, std::size_t granularity) {
        const auto base = reinterpret_cast<std::uintptr_t>(data_);
        const std::uintptr_t begin = (base + first * sizeof(T) + granularity - 1) / granularity * granularity;
        const std::uintptr_t end = (base + last * sizeof(T)) / granularity * granularity;
        if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
    }

    [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
    [[nodiscard]] std::span<T> elements() { return {data_, size_}; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

    /// Memory of the elements, rounded up to whole pages.
    [[nodiscard]] std::size_t bytes() const {
        constexpr std::size_t page = 4096;
        return (size_ * sizeof(T) + page - 1) / page * page;
    }

  private:
    [[nodiscard]] std::size_t reserved_bytes() const {
        return std::max<std::size_t>(max_size_ * sizeof(T), 1);
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t max_size_;
};

}  // namespace common
