#include "tests/fuzz/mutate_gltf.h"

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/container.h"

namespace fuzz {
namespace {

using Json = nlohmann::json;
using Generator = std::minstd_rand;

/// Returns JSON values that are easily forgotten.
Json odd_value(Generator& generator) {
    static const std::vector<Json> values = {nullptr,
                                             true,
                                             -1,
                                             0,
                                             1,
                                             2,
                                             3,
                                             255,
                                             65535,
                                             65536,
                                             2147483647,
                                             4294967295u,
                                             9007199254740993,
                                             18446744073709551615u,
                                             -2147483648,
                                             0.5,
                                             -0.0,
                                             1e-320,
                                             1e30,
                                             1e308,
                                             "",
                                             "\n",
                                             "data:application/octet-stream;base64,AAAA",
                                             "../",
                                             "MAT4",
                                             "SCALAR",
                                             Json::array(),
                                             Json::object(),
                                             Json::array({0}),
                                             Json::array({0, 0, 0}),
                                             Json::array({1e38, 1e38, 1e38}),
                                             5120,
                                             5121,
                                             5123,
                                             5125,
                                             5126};
    return values[generator() % values.size()];
}

/// Collects the value itself and everything in it.
void collect(Json& value, std::vector<Json*>& values) {
    values.push_back(&value);
    if (value.is_structured())
        for (Json& element : value) collect(element, values);
}

void change(Json& document, Generator& generator) {
    std::vector<Json*> values;
    collect(document, values);
    Json& chosen = *values[generator() % values.size()];
    switch (generator() % 4) {
        case 0:
            chosen = odd_value(generator);
            break;
        case 1:  // a copy, possibly of an element that contains this one
            chosen = Json(*values[generator() % values.size()]);
            break;
        case 2:
            if (chosen.is_array() && !chosen.empty())
                chosen.push_back(Json(chosen[generator() % chosen.size()]));
            else if (chosen.is_number_integer())
                chosen = chosen.get<std::int64_t>() + (generator() % 2 == 0 ? 1 : -1);
            break;
        default:
            if (chosen.is_structured() && !chosen.empty())
                chosen.erase(std::next(chosen.begin(), static_cast<int>(generator() % chosen.size())));
    }
}

}  // namespace

std::vector<std::uint8_t> mutated_gltf(std::span<const std::uint8_t> file, unsigned seed) {
    const common::gltf::Container parts = common::gltf::parse_container(file);
    Json document = Json::parse(parts.json, nullptr, false);
    if (document.is_discarded()) throw common::InputError("is not JSON");

    Generator generator(seed);
    for (unsigned changes = 1 + generator() % 3; changes > 0; --changes) change(document, generator);
    return common::gltf::make_glb(document.dump(-1, ' ', false, Json::error_handler_t::replace),
                                  parts.binary);
}

}  // namespace fuzz
