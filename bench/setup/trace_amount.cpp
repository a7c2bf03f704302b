#include "bench/setup/trace_amount.h"

#include "bench/setup/numbers.h"
#include "common/core/input_error.h"

namespace bench {

void TraceAmount::add_to(Command& command) {
    command.option("--hits", hits, "Trace until there are at least this many hits, e.g. 1e6");
    command.option("--photons", photons, "Trace exactly this many photons");
    command.option("--map", map, "Trace nothing: take a light map's sums from trace's file");
}

common::TraceTarget TraceAmount::target() const {
    if (!hits.empty() + !photons.empty() + !map.empty() != 1)
        throw common::InputError(
            "one of --hits and --photons says how much to trace, or --map what is traced already");
    if (!map.empty()) return {};
    if (!hits.empty()) return {.hits = parse_count("--hits", hits)};
    return {.photons = parse_count("--photons", photons)};
}

}  // namespace bench
