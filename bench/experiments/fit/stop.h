// A fit that is interrupted keeps the goals that it has finished.
#pragma once

#include "bench/setup/ending.h"
#include "common/core/interrupt.h"

namespace bench::fit {

/// Throws Interrupted where the user has ended the run.
inline void stop_if_interrupted() {
    if (common::interrupted()) throw Interrupted("fit stopped: what is not finished is not written");
}

}  // namespace bench::fit
