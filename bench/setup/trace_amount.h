// How much to trace: hits or photons, or nothing if a file has the sums of a light map.
#pragma once

#include <string>

#include "bench/setup/command.h"
#include "common/tracer/trace_photons.h"

namespace bench {

struct TraceAmount {
    std::string hits, photons, map;

    void add_to(Command& command);

    /// Whether the sums come from the file `map`.
    [[nodiscard]] bool is_traced_already() const { return !map.empty(); }

    /// Returns the target of a trace, empty if there is nothing to trace. Throws InputError unless exactly
    /// one of the three is given.
    [[nodiscard]] common::TraceTarget target() const;
};

}  // namespace bench
