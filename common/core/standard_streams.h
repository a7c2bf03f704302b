// Output of a command to stderr and stdout. A closed terminal, a pipe without a reader or a full disk of logs
// must not end work that is worth keeping.
#pragma once

#include <string>
#include <string_view>

namespace common {

/// Must be called before any file is opened. Afterwards a write to a pipe without a reader, or beyond the
/// file size limit, fails instead of ending the process. A standard stream that the caller has closed stays
/// closed. But no file opened later gets its number, and with it its output.
void secure_standard_streams();

/// Returns the text with each control character replaced by a space; file names may contain any.
[[nodiscard]] std::string one_line(std::string_view text);

/// Writes a line to stderr. Ignores failures.
void say(std::string_view line);

/// Writes a part of the result to stdout. Never throws; ask results_are_written() once, at the end.
void print_result(std::string_view text);

/// Returns whether all output to stdout, by anyone, has been written. Flushes it.
[[nodiscard]] bool results_are_written();

}  // namespace common
