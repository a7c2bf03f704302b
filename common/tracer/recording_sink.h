// Keeps all hits in their order: the input of tests and of benchmarks that time a single step.
#pragma once

#include "common/tracer/hit_batch.h"

namespace common {

class RecordingSink {
  public:
    void consume(std::span<const HitBatch> wave) {
        for (const HitBatch& batch : wave)
            for (std::size_t i = 0; i < batch.size(); ++i)
                hits_.push_back(batch.position[i], batch.direction[i], batch.flux[i], batch.surface[i]);
    }

    [[nodiscard]] const HitBatch& hits() const { return hits_; }

  private:
    HitBatch hits_;
};

static_assert(PhotonSink<RecordingSink>);

}  // namespace common
