// Allocation of large arrays with random access, in pages of 2 MiB where the system has them.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace common {

/// Allocates in pages of 2 MiB. With pages of 4 KiB, an array of more than some MiB exceeds a core's TLB, and
/// a TLB miss costs as much as the access to memory itself.
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
        madvise(memory, bytes, MADV_HUGEPAGE);  // a hint: only speed depends on it
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
