// Memory use of the process, as the allocator and the system report it.
#pragma once

#include <cstddef>

namespace common {

/// Returns the bytes that the program has allocated on the heap and not freed. The difference across a call
/// is what the call keeps, if no other thread allocates. This measures libraries that do not report their
/// memory.
[[nodiscard]] std::size_t heap_bytes();

/// Largest resident size since the start or the last reset, bytes.
[[nodiscard]] std::size_t peak_resident_bytes();

/// Current resident size, bytes.
[[nodiscard]] std::size_t resident_bytes();

/// Returns freed heap memory to the system and resets the peak to the current resident size. Returns false if
/// the system cannot reset the peak.
bool reset_peak_resident_bytes();

/// Returns the bytes that this process may still use without swapping or being killed: the smaller of the
/// limits of the machine and of its control group (version 2).
[[nodiscard]] std::size_t available_bytes();

}  // namespace common
