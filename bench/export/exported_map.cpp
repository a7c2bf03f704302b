#include "bench/export/exported_map.h"

#include <fmt/format.h>

#include <cmath>

#include "common/core/input_error.h"

namespace bench {

void require_finite(const ExportedMap& map) {
    const std::vector<shlm::half>& number = map.texels.number;
    for (std::size_t i = 0; i < number.size(); ++i)
        if (!std::isfinite(static_cast<float>(number[i])))
            throw common::InputError(
                fmt::format("{}: number {} of texel {} is not finite; nothing is exported", map.method.name,
                            i % map.texels.numbers, i / map.texels.numbers));
}

}  // namespace bench
