// Blocks traced between two tests of the target, in the two ways in which sinks take hits.
#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <utility>

#include "common/core/stopwatch.h"
#include "common/tracer/trace_report.h"

namespace common {

/// Limit of the blocks whose hits are kept until the sink reads them: enough to keep every thread busy.
inline constexpr std::size_t max_blocks_per_ordered_wave = 32;

/// Limit of the blocks that a thread traces between two calls of TraceProgress. With that many, waiting for
/// the slowest thread takes only a small part of the time.
inline constexpr std::size_t max_blocks_per_thread = 32;

/// Returns how many blocks the next ordered wave should have, so as not to trace much more than the target
/// needs. A wrong number costs only time: the run ends at the same photon for any size of wave.
[[nodiscard]] std::size_t blocks_in_next_wave(const TraceReport& so_far, const TraceTarget& target);

/// Returns how many blocks can be traced without reaching the target: 0 if it is near, if nothing is known
/// yet, and in the middle of a block. The number grows with the threads, which only changes when progress is
/// called.
[[nodiscard]] std::size_t whole_blocks_ahead(const TraceReport& so_far, const TraceTarget& target);

/// Keeps, of the block with the run's next photon, only those photons that the run still needs, and adds them
/// to the report.
void take_photons(TracedBlock& block, const TraceTarget& target, TraceReport& report);

/// Traces a whole wave, then passes it to the sink at once, cut where the target is reached.
class OrderedWaves {
  public:
    OrderedWaves(const RayScene& rays, const PhotonSource& source, std::uint64_t seed, RecordedHits recorded)
        : tracers_([&rays, &source, seed, recorded] { return BlockTracer(rays, source, seed, recorded); }) {}

    template <PhotonSink Sink>
    void trace(const TraceTarget& target, Sink& sink, TraceReport& report) {
        Stopwatch clock;
        const std::size_t blocks = blocks_in_next_wave(report, target);
        const std::uint64_t first_block = target.next_photon(report) / photons_per_block;
        if (blocks_.size() < blocks) blocks_.resize(blocks);
        if (batches_.size() < blocks) batches_.resize(blocks);
        tbb::parallel_for(std::size_t{0}, blocks,
                          [&](std::size_t i) { tracers_.local().trace(first_block + i, blocks_[i]); });
        std::size_t taken = 0;
        for (; taken < blocks && !target.reached_by(report); ++taken) {
            take_photons(blocks_[taken], target, report);
            std::swap(batches_[taken], blocks_[taken].hits);
        }
        report.trace_seconds += clock.lap();
        sink.consume(std::span<const HitBatch>(batches_).first(taken));
        report.sink_seconds += clock.lap();
    }

  private:
    tbb::enumerable_thread_specific<BlockTracer> tracers_;
    std::vector<TracedBlock> blocks_;
    std::vector<HitBatch> batches_;
};

/// Passes each block to the sink as soon as it is traced, on the same thread.
class UnorderedWaves {
  public:
    UnorderedWaves(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                   RecordedHits recorded)
        : workers_([&rays, &source, seed, recorded] { return Worker(rays, source, seed, recorded); }) {}

    /// `blocks` must begin at a block's first photon and not reach the target.
    template <UnorderedSink Sink>
    void trace(std::size_t blocks, const TraceTarget& target, Sink& sink, TraceReport& report) {
        Stopwatch clock;
        const std::uint64_t first_block = target.next_photon(report) / photons_per_block;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              Worker& worker = workers_.local();
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                  worker.trace(first_block + i, sink);
                          });
        TraceReport wave;
        for (Worker& worker : workers_) worker.report_to(wave);
        report.fates += wave.fates;
        report.hits += wave.hits;
        // Threads trace and store at the same time, so the wall time is divided in proportion to their times.
        const double wall = clock.lap(), worked = wave.trace_seconds + wave.sink_seconds;
        report.sink_seconds += wall * wave.sink_seconds / worked;
        report.trace_seconds += wall * wave.trace_seconds / worked;
    }

  private:
    /// The state of one thread.
    class Worker {
      public:
        Worker(const RayScene& rays, const PhotonSource& source, std::uint64_t seed, RecordedHits recorded)
            : tracer_(rays, source, seed, recorded) {}

        template <UnorderedSink Sink>
        void trace(std::uint64_t block, Sink& sink) {
            Stopwatch clock;
            tracer_.trace(block, traced_);
            done_.fates.add(traced_.fate);
            done_.hits += traced_.hits.size();
            done_.trace_seconds += clock.lap();
            sink.add(traced_.hits);
            done_.sink_seconds += clock.lap();
        }

        /// Adds the results since the last call.
        void report_to(TraceReport& report) {
            report.fates += done_.fates;
            report.hits += done_.hits;
            report.trace_seconds += done_.trace_seconds;
            report.sink_seconds += done_.sink_seconds;
            done_ = {};
        }

      private:
        BlockTracer tracer_;
        TracedBlock traced_;
        TraceReport done_;
    };

    tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace common
