// The parts of a contender's name, between slashes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// Taken one by one; each complaint says what was expected in its place.
class NameParts {
  public:
    NameParts(std::string option, std::string name);

    /// The next part without taking it; empty at the end of the name.
    [[nodiscard]] std::string peek() const { return next_ < parts_.size() ? parts_[next_] : ""; }

    /// The next part, or `otherwise` at the end of the name.
    std::string take(const std::string& otherwise) {
        return next_ < parts_.size() ? parts_[next_++] : otherwise;
    }

    /// The place, among `names`, of the next part; the first is the default.
    std::size_t take_one_of(const std::vector<std::string>& names);

    [[nodiscard]] bool at_end() const { return next_ == parts_.size(); }

    /// Throws InputError.
    [[noreturn]] void complain(const std::string& part, const std::string& expected) const;

  private:
    std::string option_, name_;
    std::vector<std::string> parts_;
    std::size_t next_ = 0;
};

/// "one of A, B, C"
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);

/// The number in `text` between a prefix and a suffix, where that is all there is.
[[nodiscard]] std::optional<double> number_between(std::string_view prefix, std::string_view text,
                                                   std::string_view suffix);

/// The same for a whole number within bounds, with nothing behind it.
[[nodiscard]] std::optional<std::size_t> count_after(std::string_view prefix, std::string_view text,
                                                     std::size_t least, std::size_t most);

}  // namespace bench
