#include "bench/contenders/trace_into.h"

#include "common/core/stopwatch.h"
#include "common/tracer/null_sink.h"

namespace bench {
namespace {

/// Passes each wave to all stores in turn, and measures the wall time of each.
class WavesInTurn {
  public:
    explicit WavesInTurn(std::span<FilledStore> stores) : stores_(stores) {}

    void consume(std::span<const common::HitBatch> wave) {
        common::Stopwatch clock;
        for (FilledStore& filled : stores_) {
            filled.store->consume(wave);
            filled.insert_seconds += clock.lap();
        }
    }

  private:
    std::span<FilledStore> stores_;
};

/// Adapts a store that takes any order.
struct AnyOrder {
    Store& store;

    void consume(std::span<const common::HitBatch> wave) { store.consume(wave); }
    void add(const common::HitBatch& hits) { store.add(hits); }
};

/// Adapts a store that does not.
struct InOrder {
    Store& store;

    void consume(std::span<const common::HitBatch> wave) { store.consume(wave); }
};

static_assert(common::PhotonSink<WavesInTurn> && !common::UnorderedSink<WavesInTurn>);
static_assert(common::PhotonSink<InOrder> && !common::UnorderedSink<InOrder>);
static_assert(common::UnorderedSink<AnyOrder>);

template <common::PhotonSink Sink>
common::TraceReport traced(Sink sink, const TracedRun& run) {
    return common::trace_photons(run.rays, run.source, run.seed, run.target, sink, run.progress, run.so_far,
                                 run.recorded);
}

}  // namespace

common::TraceReport trace_into(Store& store, const TracedRun& run) {
    return store.takes_any_order() ? traced(AnyOrder{store}, run) : traced(InOrder{store}, run);
}

common::TraceReport trace_into_nothing(const TracedRun& run) {
    return traced(common::NullSink(), run);
}

FilledStore::FilledStore(ContenderGroup group, PreparedScene& scene, const common::PhotonSource& source)
    : contenders(std::move(group)), preparation(contenders.front()->prepare(scene)) {
    const common::Stopwatch making_room;
    store = contenders.front()->make_store(scene, source);
    making_room_seconds = making_room.seconds();
}

common::TraceReport trace_into(std::span<FilledStore> stores, const TracedRun& run) {
    return traced(WavesInTurn(stores), run);
}

}  // namespace bench
