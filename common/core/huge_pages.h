// Memory for large arrays that are read and written all over: in pages of 2 MiB where the system has them.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace common {

/// With pages of 4 KiB the addresses of an array beyond some MiB do not fit into a core's table of pages, and
/// looking them up costs as much as fetching what is there.
template <class T>
struct HugePageAllocator {
    using value_type = T;

    HugePageAllocator() = default;
    template <class Other>
    HugePageAllocator(const HugePageAllocator<Other>&) {}  // NOLINT: allocators convert

    [[nodiscard]] T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < least_bytes) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        void* memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
        if (memory == nullptr) throw std::bad_alloc();
        madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: nothing depends on it but speed
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < least_bytes)
            ::operator delete(memory, std::align_val_t(alignof(T)));
        else
            std::free(memory);
    }

    friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }

  private:
    static constexpr std::size_t page = std::size_t{2} << 20;
    static constexpr std::size_t least_bytes = 2 * page;
};

template <class T>
using HugePageVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace common
