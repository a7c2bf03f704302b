// What an earlier run of a long command has left in its folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace bench {

struct EarlierRows {
    bool found = false;               ///< there is a table: "context" and "rows"
    bool same_context = false;        ///< its rows can stand beside rows measured now
    nlohmann::ordered_json document;  ///< the table, where found
};

/// Reads a table, if there is one. Throws InputError where the file is something else: hours of work may be
/// in what was damaged. Contexts are the same if all but their dates agree, the time when the program was
/// built included.
[[nodiscard]] EarlierRows read_earlier_rows(const std::filesystem::path& file,
                                            const nlohmann::ordered_json& context);

}  // namespace bench
