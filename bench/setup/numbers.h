// Parses numbers, also with units, and lists from the command line exactly as written. CLI11 would read 2^64
// as 2^64 - 1, 010 as eight and "1e4,,1e5" as two numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// Parses decimal digits and nothing else. Throws InputError, naming the option, unless the number is at most
/// `most`.
[[nodiscard]] std::uint64_t parse_whole_number(const std::string& option, const std::string& text,
                                               std::uint64_t most);

/// Parses "0.5" or "1e-3". Throws InputError, naming the option, unless it is one finite number.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);

/// Returns the parts between commas of all texts, in order. Throws InputError, naming the option, if one is
/// empty.
[[nodiscard]] std::vector<std::string> parse_list(const std::string& option,
                                                  const std::vector<std::string>& texts);

/// Parses numbers separated by commas. Throws InputError, naming the option, unless there are `count` of them
/// and none is too large for a float.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                                std::size_t count);

/// Parses "1e6" or "250000". Throws InputError, naming the option, unless it is a whole number from 1 to
/// 1e15.
[[nodiscard]] std::uint64_t parse_count(const std::string& option, const std::string& text);

/// Parses "60s", "5min" or "1h". Throws InputError, naming the option, for anything else.
[[nodiscard]] double parse_seconds(const std::string& option, const std::string& text);

/// Parses "0.1%" as 0.001. Throws InputError, naming the option, unless it is more than 0 % and less than 100
/// %.
[[nodiscard]] double parse_percentage(const std::string& option, const std::string& text);

/// Parses several counts; returns each once, in ascending order.
[[nodiscard]] std::vector<std::uint64_t> parse_sizes(const std::string& option,
                                                     const std::vector<std::string>& texts);

/// Parses "20GiB", "512MiB" or "1000000". Throws InputError, naming the option, for anything else.
[[nodiscard]] std::size_t parse_bytes(const std::string& option, const std::string& text);

}  // namespace bench
