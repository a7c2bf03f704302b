// The results that an earlier run of a long command has left in its folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace bench {

struct EarlierRows {
    bool found = false;               ///< there is a table: "context" and "rows"
    bool same_context = false;        ///< its rows are comparable with rows measured now
    nlohmann::ordered_json document;  ///< the table, if found
};

/// Reads a table, if there is one. Throws InputError where the file is something else, as a damaged file may
/// hold hours of work. Contexts are the same if they agree in all but their dates; they include the build
/// time of the program.
[[nodiscard]] EarlierRows read_earlier_rows(const std::filesystem::path& file,
                                            const nlohmann::ordered_json& context);

}  // namespace bench
