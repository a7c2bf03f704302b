// A fit that is interrupted keeps nothing.
#pragma once

#include "bench/app/ending.h"
#include "common/core/interrupt.h"

namespace bench::fit {

/// Throws Interrupted where the user has ended the run.
inline void stop_if_interrupted() {
    if (common::interrupted()) throw Interrupted("fit stopped: nothing is written");
}

}  // namespace bench::fit
