// Photon tracing: blocks of photons in parallel, their hits to a sink in a fixed order.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <chrono>
#include <functional>

#include "common/tracer/trace_block.h"

namespace common {

/// When a run is long enough: one of the two is asked for, the other is 0.
struct TraceTarget {
    std::uint64_t photons = 0;  ///< emitted, exactly
    std::uint64_t hits = 0;     ///< at least, by whole blocks of photons
};

struct TraceReport {
    PhotonFates fates;
    std::uint64_t hits = 0;
    double trace_seconds = 0;  ///< wall time outside the sink
    double sink_seconds = 0;   ///< wall time inside the sink
    bool interrupted = false;

    /// What turns HitBatch::flux into W. The only place where the number of emitted photons is divided by.
    [[nodiscard]] float watts_per_flux() const {
        return fates.emitted == 0 ? 0.0f : static_cast<float>(1.0 / static_cast<double>(fates.emitted));
    }
};

/// Called between waves with what is done so far; returns false to end the run there.
using TraceProgress = std::function<bool(const TraceReport& so_far)>;

/// Blocks traced between two calls of the sink, at most: enough to keep every thread busy, few enough for the
/// hits to stay in cache until the sink reads them.
inline constexpr std::size_t max_blocks_per_wave = 64;

/// How many blocks the next wave should have so as not to trace much more than the target needs. Costs time
/// only when wrong: the run ends at the same block for any size of wave.
[[nodiscard]] std::size_t blocks_in_next_wave(const TraceReport& so_far, const TraceTarget& target);

/// Throws InputError where so many photons have met nothing that the target will not be reached.
void check_that_photons_hit(const TraceReport& so_far, const TraceTarget& target);

/// Traces photons 0, 1, 2, ... of the run with this seed and gives their hits to `sink`.
///
/// The hits, their order and the report's counts depend on the scene, the seed and the target alone. Uses the
/// threads of the calling arena (see ThreadPool).
template <PhotonSink Sink>
TraceReport trace_photons(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                          TraceTarget target, Sink& sink, const TraceProgress& progress = {}) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
    const auto reached = [&](const TraceReport& r) {
        return (target.photons == 0 || r.fates.emitted >= target.photons) &&
               (target.hits == 0 || r.hits >= target.hits);
    };
    std::vector<HitBatch> batches(max_blocks_per_wave);
    std::vector<PhotonFates> fates(max_blocks_per_wave);
    TraceReport report;

    for (std::uint64_t first_block = 0; !reached(report);) {
        const auto start = Clock::now();
        const std::size_t blocks = blocks_in_next_wave(report, target);
        tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t i) {
            const std::uint64_t first_photon = (first_block + i) * photons_per_block;
            const std::uint64_t wanted =
                target.photons > first_photon ? target.photons - first_photon : photons_per_block;
            fates[i] = trace_block(rays, source, seed, first_photon, std::min(wanted, photons_per_block),
                                   batches[i]);
        });
        // The run ends at the block that reaches the target, not at the end of the wave.
        std::size_t taken = 0;
        while (taken < blocks && !reached(report)) {
            report.fates += fates[taken];
            report.hits += batches[taken].size();
            ++taken;
        }
        const auto traced = Clock::now();
        sink.consume(std::span<const HitBatch>(batches).first(taken));
        report.trace_seconds += seconds(traced - start);
        report.sink_seconds += seconds(Clock::now() - traced);
        first_block += taken;

        check_that_photons_hit(report, target);
        if (progress && !progress(report)) {
            report.interrupted = true;
            break;
        }
    }
    return report;
}

/// The finished, immutable map of a sink that has taken a whole run.
template <MapSink Sink>
[[nodiscard]] auto finish_map(Sink&& sink, const TraceReport& report) {
    return std::move(sink).finish(report.watts_per_flux());
}

}  // namespace common
