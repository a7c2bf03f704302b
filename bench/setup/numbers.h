// Numbers and lists on the command line, read as they are written. CLI11 would take 2^64 for 2^64 - 1,
// 010 for eight and "1e4,,1e5" for two numbers.
#pragma once

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

}  // namespace bench
