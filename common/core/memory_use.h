// How much memory the process uses, asked where it is handed out.
#pragma once

#include <cstddef>

namespace common {

/// Bytes that the program has allocated on the heap and not freed. The difference across a call, with no
/// other thread allocating, is what the call keeps: for libraries that cannot say so themselves.
[[nodiscard]] std::size_t heap_bytes();

/// Largest resident size since the start or the last reset, bytes.
[[nodiscard]] std::size_t peak_resident_bytes();

/// Resident now, bytes.
[[nodiscard]] std::size_t resident_bytes();

/// Gives freed heap memory back to the system and starts the peak anew from what is resident now. False where
/// the system does not let the peak be reset.
bool reset_peak_resident_bytes();

/// Memory that this process may still use without swapping or being killed, bytes: of the machine, and of its
/// control group (version 2) where that is less.
[[nodiscard]] std::size_t available_bytes();

}  // namespace common
