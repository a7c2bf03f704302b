// Runs the photon tracer on scenes built in code.
#pragma once

#include <cstring>

#include "bench/setup/traced_hits.h"
#include "common/core/threads.h"
#include "common/tracer/trace_photons.h"
#include "shlm/sums/quantum.h"
#include "tests/support/scene_builder.h"

namespace tests {

template <class Sink>
common::TraceReport trace(const Scene& scene, std::uint64_t seed, common::TraceTarget target, Sink& sink,
                          const common::TraceProgress& progress = {}) {
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    return common::trace_photons(rays, source, seed, target, sink, progress);
}

using TracedRun = bench::TracedHits;

inline TracedRun record(const Scene& scene, std::uint64_t seed, common::TraceTarget target) {
    return bench::traced(scene, seed, target);
}

/// Returns whether the first elements of two columns are bitwise equal.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b, std::size_t count) {
    return a.size() >= count && b.size() >= count && std::memcmp(a.data(), b.data(), count * sizeof(T)) == 0;
}

/// Returns whether `longer` begins with all of `shorter`, bit by bit.
inline bool begins_with(const common::HitBatch& longer, const common::HitBatch& shorter) {
    const std::size_t count = shorter.size();
    return same_bits(longer.position, shorter.position, count) &&
           same_bits(longer.direction, shorter.direction, count) &&
           same_bits(longer.flux, shorter.flux, count) && same_bits(longer.surface, shorter.surface, count);
}

inline bool same_hits(const common::HitBatch& a, const common::HitBatch& b) {
    return a.size() == b.size() && begins_with(a, b);
}

/// Returns the quantum for the light of a scene, or for hits made by hand as if the brightest carried all the
/// light.
inline shlm::Quantum quantum_for(const Scene& scene) {
    return shlm::Quantum(common::PhotonSource(scene).power());
}

inline shlm::Quantum quantum_for(std::span<const common::HitBatch> batches) {
    Rgb brightest(0, 0, 0);
    for (const common::HitBatch& hits : batches)
        for (std::size_t i = 0; i < hits.size(); ++i)
            for (int c = 0; c < 3; ++c)
                if (common::is_finite(hits, i)) brightest[c] = std::max(brightest[c], hits.flux[i][c]);
    return shlm::Quantum(brightest);
}

inline shlm::Quantum quantum_for(const common::HitBatch& hits) {
    return quantum_for(std::span(&hits, 1));
}

/// Cuts hits into batches of `size`.
inline std::vector<common::HitBatch> in_batches(const common::HitBatch& hits, std::size_t size) {
    std::vector<common::HitBatch> batches((hits.size() + size - 1) / size);
    for (std::size_t i = 0; i < hits.size(); ++i)
        batches[i / size].push_back(hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i]);
    return batches;
}

/// Passes every wave to all of its sinks.
template <class... Sinks>
class Tee {
  public:
    explicit Tee(Sinks&... sinks) : sinks_(&sinks...) {}
    void consume(std::span<const common::HitBatch> wave) {
        std::apply([&](auto*... sink) { (sink->consume(wave), ...); }, sinks_);
    }

  private:
    std::tuple<Sinks*...> sinks_;
};

}  // namespace tests
