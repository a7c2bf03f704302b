#include "bench/setup/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "common/core/input_error.h"

namespace bench {

using common::InputError;

std::uint64_t parse_whole_number(const std::string& option, const std::string& text, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value > most)
        throw InputError(fmt::format("{}: '{}' is not a whole number from 0 to {}", option, text, most));
    return value;
}

double parse_number(const std::string& option, const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value))
        throw InputError(fmt::format("{}: '{}' is not a number", option, text));
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

}  // namespace bench
