// Asking for an object's cache lines before it is needed.
#pragma once

#include <cstddef>

namespace common {

enum class PrefetchFor { reading, writing };

template <PrefetchFor Use, class T>
void prefetch(const T& object) {
    constexpr std::size_t line = 64;
    for (std::size_t at = 0; at < sizeof(T); at += line)
        __builtin_prefetch(reinterpret_cast<const char*>(&object) + at, Use == PrefetchFor::writing);
}

}  // namespace common
