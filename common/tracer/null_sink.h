// Forgets every hit: what tracing costs without a store.
#pragma once

#include "common/tracer/hit_batch.h"

namespace common {

struct NullSink {
    void consume(std::span<const HitBatch>) {}
};

static_assert(PhotonSink<NullSink>);

}  // namespace common
