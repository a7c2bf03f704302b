// The page's own files, which the build puts into the program.
#pragma once

#include <string_view>

namespace bench {

/// Text of bench/viewer/NAME. Throws std::out_of_range for other names.
[[nodiscard]] std::string_view viewer_asset(std::string_view name);

}  // namespace bench
