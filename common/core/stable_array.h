// An array that grows without moving.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace common {

/// Elements keep their addresses while the array grows and when it is moved, growing copies nothing, and
/// memory is taken from the system only as elements are written: address space for `max_size` of them is
/// reserved up front (mmap(2)).
template <class T>
requires std::is_trivially_destructible_v<T>
class StableArray {
  public:
    /// Throws std::bad_alloc where the system does not give that much address space.
    explicit StableArray(std::size_t max_size) : max_size_(max_size) {
        void* memory = mmap(nullptr, reserved_bytes(), PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        data_ = static_cast<T*>(memory);
        madvise(memory, reserved_bytes(),
                MADV_HUGEPAGE);  // fewer page faults; refused on some systems, and then no loss
    }

    StableArray(StableArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)),
          max_size_(std::exchange(other.max_size_, 0)) {}
    StableArray& operator=(StableArray&&) = delete;

    ~StableArray() {
        if (data_) munmap(data_, reserved_bytes());
    }

    /// Makes room for `count` more elements and returns it, zero until written. Throws std::bad_alloc past
    /// max_size.
    std::span<T> grow(std::size_t count) {
        if (count > max_size_ - size_) throw std::bad_alloc();
        size_ += count;
        return {data_ + size_ - count, count};
    }

    [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

    /// What its elements take, to the page.
    [[nodiscard]] std::size_t bytes() const {
        constexpr std::size_t page = 4096;
        return (size_ * sizeof(T) + page - 1) / page * page;
    }

  private:
    [[nodiscard]] std::size_t reserved_bytes() const { return max_size_ * sizeof(T); }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t max_size_;
};

}  // namespace common
