// The parts of a contender's name, separated by slashes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// Hands out the parts one by one. Each complaint says what was expected in place of a part.
class NameParts {
  public:
    NameParts(std::string option, std::string name);

    /// Returns the next part without taking it; empty at the end of the name.
    [[nodiscard]] std::string peek() const { return next_ < parts_.size() ? parts_[next_] : ""; }

    /// Takes the next part, or returns `otherwise` at the end of the name.
    std::string take(const std::string& otherwise) {
        return next_ < parts_.size() ? parts_[next_++] : otherwise;
    }

    /// Takes the next part and returns its index in `names`; the default is the first.
    std::size_t take_one_of(const std::vector<std::string>& names);

    [[nodiscard]] bool at_end() const { return next_ == parts_.size(); }

    /// Throws InputError.
    [[noreturn]] void complain(const std::string& part, const std::string& expected) const;

  private:
    std::string option_, name_;
    std::vector<std::string> parts_;
    std::size_t next_ = 0;
};

/// Returns "one of A, B, C".
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);

/// Returns the number between prefix and suffix, or none where `text` has another form.
[[nodiscard]] std::optional<double> number_between(std::string_view prefix, std::string_view text,
                                                   std::string_view suffix);

/// Returns a whole number within bounds after the prefix, or none where `text` has another form.
[[nodiscard]] std::optional<std::size_t> count_after(std::string_view prefix, std::string_view text,
                                                     std::size_t least, std::size_t most);

}  // namespace bench
