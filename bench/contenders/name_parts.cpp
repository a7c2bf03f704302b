#include "bench/contenders/name_parts.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/core/input_error.h"

namespace bench {

NameParts::NameParts(std::string option, std::string name)
    : option_(std::move(option)), name_(std::move(name)) {
    for (std::size_t begin = 0; begin <= name_.size();) {
        const std::size_t end = std::min(name_.find('/', begin), name_.size());
        parts_.push_back(name_.substr(begin, end - begin));
        begin = end + 1;
    }
}

std::size_t NameParts::take_one_of(const std::vector<std::string>& names) {
    const std::string part = take(names.front());
    const auto found = std::find(names.begin(), names.end(), part);
    if (found == names.end()) complain(part, one_of(names));
    return static_cast<std::size_t>(found - names.begin());
}

void NameParts::complain(const std::string& part, const std::string& expected) const {
    throw common::InputError(
        fmt::format("{}: '{}' in the method '{}' is not {}", option_, part, name_, expected));
}

std::string one_of(const std::vector<std::string>& names) {
    return fmt::format("one of {}", fmt::join(names, ", "));
}

std::optional<double> number_between(std::string_view prefix, std::string_view text,
                                     std::string_view suffix) {
    if (!text.starts_with(prefix) || !text.ends_with(suffix) || text.size() <= prefix.size() + suffix.size())
        return std::nullopt;
    const char* const end = text.data() + text.size() - suffix.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::size_t> count_after(std::string_view prefix, std::string_view text, std::size_t least,
                                       std::size_t most) {
    const auto value = number_between(prefix, text, "");
    if (!value || *value < static_cast<double>(least) || *value > static_cast<double>(most) ||
        *value != std::floor(*value))
        return std::nullopt;
    return static_cast<std::size_t>(*value);
}

}  // namespace bench
