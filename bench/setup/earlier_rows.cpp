#include "bench/setup/earlier_rows.h"

#include <fmt/format.h>

#include <fstream>

#include "common/core/input_error.h"

namespace bench {

EarlierRows read_earlier_rows(const std::filesystem::path& file, const nlohmann::ordered_json& context) {
    std::ifstream in(file);
    EarlierRows earlier;
    if (!in && !std::filesystem::exists(file)) return earlier;
    earlier.document = nlohmann::ordered_json::parse(in, nullptr, false);
    const nlohmann::ordered_json& table = earlier.document;
    earlier.found = table.contains("context") && table["context"].is_object() && table.contains("rows") &&
                    table["rows"].is_array();
    if (!earlier.found)
        throw common::InputError(
            fmt::format("{}: not a table of earlier rows; remove it first", file.string()));
    nlohmann::ordered_json before = earlier.document["context"], now = context;
    before.erase("date");
    now.erase("date");
    earlier.same_context = before == now;
    return earlier;
}

}  // namespace bench
