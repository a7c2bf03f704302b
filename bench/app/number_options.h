// Options whose values are numbers or lists, read as they are written. CLI11 would take 2^64 for 2^64 - 1,
// 010 for eight and "1e4,,1e5" for two numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <limits>
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

/// An option for a whole number that is not negative; its bounds are its command's to check.
template <std::integral Number>
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, Number& value,
                              const std::string& description) {
    const auto read = [name, &value](const std::string& text) {
        value = static_cast<Number>(parse_whole_number(name, text, std::numeric_limits<Number>::max()));
    };
    return command.add_option_function<std::string>(name, read, description)
        ->type_name("UINT")
        ->default_str(std::to_string(value));
}

/// An option for any number. `value`: double, or optional of it.
template <class Number>
CLI::Option* add_number(CLI::App& command, const std::string& name, Number& value,
                        const std::string& description) {
    const auto read = [name, &value](const std::string& text) { value = parse_number(name, text); };
    return command.add_option_function<std::string>(name, read, description)->type_name("FLOAT");
}

}  // namespace bench
