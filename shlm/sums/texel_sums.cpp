#include "shlm/sums/texel_sums.h"

#include <fmt/format.h>

#include "common/core/input_error.h"

namespace shlm {

void throw_texel_is_full(std::size_t texel) {
    throw common::InputError(fmt::format(
        "texel {} has taken more light than its sums can hold; fewer hits or more texels", texel));
}

}  // namespace shlm
