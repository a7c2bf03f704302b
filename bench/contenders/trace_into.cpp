#include "bench/contenders/trace_into.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <numeric>

#include "common/core/stopwatch.h"
#include "common/tracer/null_sink.h"

namespace bench {
namespace {

using Seconds = std::vector<double>;

/// A wave for each in turn.
class WavesInTurn {
  public:
    explicit WavesInTurn(std::span<Store* const> stores) : stores_(stores), seconds_(stores.size()) {}

    void consume(std::span<const common::HitBatch> wave) {
        common::Stopwatch clock;
        for (std::size_t i = 0; i < stores_.size(); ++i) {
            stores_[i]->consume(wave);
            seconds_[i] += clock.lap();
        }
    }

    [[nodiscard]] Seconds seconds() const { return seconds_; }

  protected:
    std::span<Store* const> stores_;

  private:
    Seconds seconds_;
};

/// A block for each in turn, by the thread that traced it.
class BlocksInTurn : public WavesInTurn {
  public:
    explicit BlocksInTurn(std::span<Store* const> stores)
        : WavesInTurn(stores), of_thread_([count = stores.size()] { return Seconds(count); }) {}

    void add(const common::HitBatch& hits) {
        Seconds& seconds = of_thread_.local();
        common::Stopwatch clock;
        for (std::size_t i = 0; i < stores_.size(); ++i) {
            stores_[i]->add(hits);
            seconds[i] += clock.lap();
        }
    }

    /// Of threads at the same time and of waves: their shares count, not their sum.
    [[nodiscard]] Seconds seconds() const {
        Seconds sum = WavesInTurn::seconds();
        for (const Seconds& some : of_thread_)
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += some[i];
        return sum;
    }

  private:
    tbb::enumerable_thread_specific<Seconds> of_thread_;
};

static_assert(common::PhotonSink<WavesInTurn> && !common::UnorderedSink<WavesInTurn>);
static_assert(common::UnorderedSink<BlocksInTurn>);

template <class Sink>
StoresTrace traced(Sink sink, const TracedRun& run) {
    StoresTrace trace;
    trace.report =
        common::trace_photons(run.rays, run.source, run.seed, run.target, sink, run.progress, run.so_far);
    trace.insert_seconds = sink.seconds();
    // The stores share out the wall time that storing has taken as they took their threads' time.
    const double spent = std::accumulate(trace.insert_seconds.begin(), trace.insert_seconds.end(), 0.0);
    const double wall = trace.report.sink_seconds - run.so_far.sink_seconds;
    for (double& seconds : trace.insert_seconds) seconds *= spent > 0 ? wall / spent : 0;
    return trace;
}

}  // namespace

StoresTrace trace_into(std::span<Store* const> stores, const TracedRun& run) {
    std::vector<Store*> sorted(stores.begin(), stores.end());
    const auto middle = std::stable_partition(sorted.begin(), sorted.end(),
                                              [](const Store* store) { return store->takes_any_order(); });
    const auto any_order = std::span(sorted).first(static_cast<std::size_t>(middle - sorted.begin()));
    const auto in_order = std::span(sorted).subspan(any_order.size());
    if (in_order.empty() || any_order.empty())
        return in_order.empty() ? traced(BlocksInTurn(stores), run) : traced(WavesInTurn(stores), run);

    const StoresTrace first = traced(BlocksInTurn(any_order), run);
    if (first.report.interrupted) return {first.report, Seconds(stores.size())};
    const StoresTrace second = traced(WavesInTurn(in_order), run);
    StoresTrace both{first.report, Seconds(stores.size())};
    both.report.interrupted = second.report.interrupted;
    both.report.sink_seconds += second.report.sink_seconds;
    for (std::size_t i = 0; i < stores.size(); ++i) {
        const auto place =
            static_cast<std::size_t>(std::find(sorted.begin(), sorted.end(), stores[i]) - sorted.begin());
        both.insert_seconds[i] = place < any_order.size() ? first.insert_seconds[place]
                                                          : second.insert_seconds[place - any_order.size()];
    }
    return both;
}

common::TraceReport trace_into(Store& store, const TracedRun& run) {
    Store* const only = &store;
    return trace_into(std::span(&only, 1), run).report;
}

common::TraceReport trace_into_nothing(const TracedRun& run) {
    common::NullSink sink;
    return common::trace_photons(run.rays, run.source, run.seed, run.target, sink, run.progress, run.so_far);
}

FilledStore::FilledStore(ContenderGroup group, PreparedScene& scene, const common::PhotonSource& source)
    : contenders(std::move(group)) {
    contenders.front()->prepare(scene);  // the scene's, not the run's
    const common::Stopwatch making_room;
    store = contenders.front()->make_store(scene, source);
    making_room_seconds = making_room.seconds();
}

common::TraceReport trace_into(std::span<FilledStore> stores, const TracedRun& run) {
    std::vector<Store*> all;
    for (const FilledStore& filled : stores) all.push_back(filled.store.get());
    const StoresTrace trace = trace_into(std::span<Store* const>(all), run);
    for (std::size_t i = 0; i < stores.size(); ++i) stores[i].insert_seconds += trace.insert_seconds[i];
    return trace.report;
}

}  // namespace bench
