#include "bench/app/earlier_rows.h"

#include <fmt/format.h>

#include <fstream>

#include "common/core/input_error.h"

namespace bench {

EarlierRows read_earlier_rows(const std::filesystem::path& file, const nlohmann::ordered_json& context) {
    std::ifstream in(file);
    EarlierRows earlier;
    if (!in && !std::filesystem::exists(file)) return earlier;
    earlier.document = nlohmann::ordered_json::parse(in, nullptr, false);
    const auto has = [&](const char* key, auto is_kind) {
        return earlier.document.is_object() && earlier.document.contains(key) &&
               is_kind(earlier.document[key]);
    };
    earlier.found = has("context", [](const auto& value) { return value.is_object(); }) &&
                    has("rows", [](const auto& value) { return value.is_array(); });
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
