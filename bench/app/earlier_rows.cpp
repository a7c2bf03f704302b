#include "bench/app/earlier_rows.h"

#include <fstream>

namespace bench {

EarlierRows read_earlier_rows(const std::filesystem::path& file, const nlohmann::ordered_json& context) {
    std::ifstream in(file);
    EarlierRows earlier;
    earlier.document = nlohmann::ordered_json::parse(in, nullptr, false);
    earlier.found = earlier.document.is_object() && earlier.document.contains("context") &&
                    earlier.document.contains("rows");
    if (!earlier.found) return earlier;
    nlohmann::ordered_json before = earlier.document["context"], now = context;
    before.erase("date");
    now.erase("date");
    earlier.same_context = before == now;
    return earlier;
}

}  // namespace bench
