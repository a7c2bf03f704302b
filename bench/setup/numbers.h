// Numbers, also with units, and lists on the command line, read as they are written. CLI11 would take 2^64
// for 2^64 - 1, 010 for eight and "1e4,,1e5" for two numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// Decimal digits and nothing else. Throws InputError, naming the option, unless the number is at most
/// `most`.
[[nodiscard]] std::uint64_t parse_whole_number(const std::string& option, const std::string& text,
                                               std::uint64_t most);

/// "0.5", "1e-3". Throws InputError, naming the option, unless it is one finite number.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);

/// The parts between commas of all texts, in order. Throws InputError, naming the option, where one is empty.
[[nodiscard]] std::vector<std::string> parse_list(const std::string& option,
                                                  const std::vector<std::string>& texts);

/// Numbers separated by commas. Throws InputError, naming the option, unless there are `count` of them, none
/// too large for a float.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                                std::size_t count);

/// "1e6", "250000". Throws InputError, naming the option, unless it is a whole number from 1 to 1e15.
[[nodiscard]] std::uint64_t parse_count(const std::string& option, const std::string& text);

/// "60s", "5min", "1h". Throws InputError, naming the option, for anything else.
[[nodiscard]] double parse_seconds(const std::string& option, const std::string& text);

/// "0.1%" is 0.001. Throws InputError, naming the option, unless it is more than 0 % and less than 100 %.
[[nodiscard]] double parse_percentage(const std::string& option, const std::string& text);

/// Several of them, ascending, each once.
[[nodiscard]] std::vector<std::uint64_t> parse_sizes(const std::string& option,
                                                     const std::vector<std::string>& texts);

/// "20GiB", "512MiB", "1000000". Throws InputError, naming the option, for anything else.
[[nodiscard]] std::size_t parse_bytes(const std::string& option, const std::string& text);

}  // namespace bench
