// Warnings of the loader about a file, merged into a few lines, and texts cut down to one line.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace common::gltf {

/// Returns the first line of `text` without control characters, truncated if it is too long to read. Names
/// and messages that come from a file can be anything.
[[nodiscard]] std::string one_line(std::string_view text);

/// Collects what was read but not honoured. The same complaint about many places becomes one line.
class Warnings {
  public:
    /// `what` is the complaint, `where` the part of the file it is about.
    void add(const std::string& what, const std::string& where);

    /// "what: where", or "what: where and 3 more", in the order in which they came up.
    [[nodiscard]] std::vector<std::string> lines() const;

  private:
    struct Entry {
        std::string what;
        std::string first_place;
        std::size_t places;
    };
    std::vector<Entry> entries_;
    std::map<std::string, std::size_t> entry_of_;  ///< by complaint
};

}  // namespace common::gltf
