// Builds scenes in code, as the stability cases do.
#pragma once

#include "bench/setup/scene_builder.h"

namespace tests {

using namespace bench::scene_builder;

}  // namespace tests
