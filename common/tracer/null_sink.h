// Discards every hit, to measure the cost of tracing without a store.
#pragma once

#include "common/tracer/hit_batch.h"

namespace common {

struct NullSink {
    void consume(std::span<const HitBatch>) {}
    void add(const HitBatch&) {}
};

static_assert(UnorderedSink<NullSink>);

}  // namespace common
