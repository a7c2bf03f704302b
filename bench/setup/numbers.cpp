#include "bench/setup/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "common/core/input_error.h"

namespace bench {
namespace {

using common::InputError;

/// Parses the number at the start of `text` and removes it from there. Throws InputError where there is none.
double take_number(const std::string& option, std::string_view& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value))
        throw InputError(fmt::format("{}: '{}' is not a number", option, text));
    text.remove_prefix(end - text.data());
    return value;
}

}  // namespace

std::uint64_t parse_whole_number(const std::string& option, const std::string& text, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value > most)
        throw InputError(fmt::format("{}: '{}' is not a whole number from 0 to {}", option, text, most));
    return value;
}

double parse_number(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    if (!rest.empty()) throw InputError(fmt::format("{}: '{}' is not a number", option, text));
    return value;
}

std::vector<std::string> parse_list(const std::string& option, const std::vector<std::string>& texts) {
    std::vector<std::string> parts;
    for (const std::string& text : texts)
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            if (begin == end)
                throw InputError(fmt::format("{}: '{}' has an empty place in its list", option, text));
            parts.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    return parts;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    std::string_view rest = text;
    while (true) {
        const double number = take_number(option, rest);
        if (std::abs(number) > std::numeric_limits<float>::max())
            throw InputError(fmt::format("{}: '{}' has a number that is too large", option, text));
        numbers.push_back(number);
        if (rest.empty()) break;
        if (rest.front() != ',')
            throw InputError(fmt::format("{}: numbers are separated by commas in '{}'", option, text));
        rest.remove_prefix(1);
    }
    if (numbers.size() != count)
        throw InputError(
            fmt::format("{}: {} numbers are needed, '{}' has {}", option, count, text, numbers.size()));
    return numbers;
}

std::uint64_t parse_count(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    if (!rest.empty() || !(value >= 1 && value <= 1e15) || value != std::floor(value))
        throw InputError(fmt::format("{}: '{}' is not a whole number from 1 to 1e15", option, text));
    return static_cast<std::uint64_t>(value);
}

double parse_seconds(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    const double unit = rest == "s" ? 1 : rest == "min" ? 60 : rest == "h" ? 3600 : 0;
    if (unit == 0 || !(value >= 0 && value * unit < 1e9))
        throw InputError(fmt::format("{}: '{}' is not a time such as 60s, 5min or 1h", option, text));
    return value * unit;
}

double parse_percentage(const std::string& option, const std::string& text) {
    if (!text.ends_with('%'))
        throw InputError(fmt::format("{}: '{}' is not a percentage such as 0.1%", option, text));
    const double percent = parse_number(option, text.substr(0, text.size() - 1));
    if (!(percent > 0 && percent < 100))
        throw InputError(fmt::format("{}: more than 0% and less than 100%", option));
    return percent / 100;
}

std::vector<std::uint64_t> parse_sizes(const std::string& option, const std::vector<std::string>& texts) {
    std::set<std::uint64_t> sizes;
    for (const std::string& text : texts) sizes.insert(parse_count(option, text));
    return {sizes.begin(), sizes.end()};
}

std::size_t parse_bytes(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    const double unit = rest == "GiB" ? 0x1p30 : rest == "MiB" ? 0x1p20 : rest.empty() ? 1 : 0;
    if (unit == 0 || !(value * unit >= 1 && value * unit < 0x1p62))
        throw InputError(fmt::format("{}: '{}' is not a size such as 512MiB or 20GiB", option, text));
    return static_cast<std::size_t>(value * unit);
}

}  // namespace bench
