// What a command says on its way and at its end. Terminals are closed, pipes lose their readers and disks
// that hold logs fill up: nothing of that may end work that is worth keeping.
#pragma once

#include <string>
#include <string_view>

namespace common {

/// To be called before anything is opened. A pipe without a reader and a file that may not grow are from now
/// on errors of the write; a standard stream that the caller has closed stays lost, but no file that is
/// opened later gets its number, and with it what is said.
void secure_standard_streams();

/// The text with a space for each control character: file names may have any.
[[nodiscard]] std::string one_line(std::string_view text);

/// Writes a line to stderr, where it can be written.
void say(std::string_view line);

/// Writes a part of the result to stdout. Never throws: whether all of it got there is asked once, at the
/// end.
void print_result(std::string_view text);

/// Whether stdout has all that was printed, by anyone. Flushes it.
[[nodiscard]] bool results_are_written();

}  // namespace common
