// The interface of the module that contains OpenImageIO.
#pragma once

#include "common/image/image_reader.h"

namespace common {

/// Returns a new reader of `file`, or null with the reason in `error`.
using OpenOtherFormat = ImageReader*(const char* file, std::string& error);

inline constexpr const char* open_other_format_symbol = "shlmbench_open_other_format";

}  // namespace common
