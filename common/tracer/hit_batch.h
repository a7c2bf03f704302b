// The hits of one block of photons, and what a consumer of hits looks like.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/scene/surface_point.h"
#include "common/tracer/rejected_hits.h"

namespace common {

/// Arrivals of photons on diffuse surfaces and in their holes, structure of arrays, in an order that depends
/// on the block's photons alone. Each arrival is recorded before its own reflection: `flux` is what the
/// photon carries towards the surface.
struct HitBatch {
    std::vector<Vec3> position;   ///< world units, on the surface
    std::vector<Vec3> direction;  ///< unit, the way the photon travels: towards the surface
    std::vector<Rgb> flux;        ///< W times the number of photons emitted in the whole run
    std::vector<SurfaceId> surface;
    std::vector<std::uint32_t> photon;  ///< whose arrival it is, counted from the first photon of the block

    [[nodiscard]] std::size_t size() const { return position.size(); }

    void clear() { resize(0); }

    void reserve(std::size_t hits) {
        position.reserve(hits);
        direction.reserve(hits);
        flux.reserve(hits);
        surface.reserve(hits);
        photon.reserve(hits);
    }

    /// What is new has no defined value.
    void resize(std::size_t hits) {
        position.resize(hits);
        direction.resize(hits);
        flux.resize(hits);
        surface.resize(hits);
        photon.resize(hits);
    }

    void set(std::size_t i, const Vec3& at, const Vec3& travelling, const Rgb& carried, const SurfaceId& on,
             std::uint32_t by) {
        position[i] = at;
        direction[i] = travelling;
        flux[i] = carried;
        surface[i] = on;
        photon[i] = by;
    }

    void push_back(const Vec3& at, const Vec3& travelling, const Rgb& carried, const SurfaceId& on,
                   std::uint32_t by = 0) {
        resize(size() + 1);
        set(size() - 1, at, travelling, carried, on, by);
    }
};

/// Whether hit `i` can be stored: one NaN would spoil a whole map.
[[nodiscard]] inline bool is_finite(const HitBatch& batch, std::size_t i) {
    const Vec3 &at = batch.position[i], &along = batch.direction[i], &flux = batch.flux[i];
    // 0 times anything finite is 0, in nine multiplications and without a branch.
    return at.x * 0 + at.y * 0 + at.z * 0 + along.x * 0 + along.y * 0 + along.z * 0 + flux.x * 0 +
               flux.y * 0 + flux.z * 0 ==
           0;
}

[[nodiscard]] inline std::size_t count_hits(std::span<const HitBatch> wave) {
    std::size_t hits = 0;
    for (const HitBatch& batch : wave) hits += batch.size();
    return hits;
}

/// Takes the hits of a run, wave after wave. Waves come in the order of their photons, one at a time, and the
/// views are valid during the call only. A sink may use oneTBB inside; what it has stored in the end must not
/// depend on how the batches were cut into waves or on the number of threads.
template <class S>
concept PhotonSink = requires(S& sink, std::span<const HitBatch> wave) {
    { sink.consume(wave) } -> std::same_as<void>;
};

/// Also takes batches from several threads at once, in any order: what it has stored in the end does not
/// depend on it. Hits then go to their store while they are in the cache of the thread that traced them.
template <class S>
concept UnorderedSink = PhotonSink<S> && requires(S& sink, const HitBatch& batch) {
    { sink.add(batch) } -> std::same_as<void>;
};

/// A sink that becomes a map which can be asked for irradiance. `watts_per_flux` turns HitBatch::flux into W;
/// `bytes` is what it holds while it takes hits, `rejected` what it could not take.
template <class S>
concept MapSink = PhotonSink<S> && requires(S sink, const S& filled, float watts_per_flux) {
    { std::move(sink).finish(watts_per_flux) } -> IrradianceEstimator;
    { filled.bytes() } -> std::same_as<std::size_t>;
    { filled.rejected() } -> std::convertible_to<RejectedHits>;
};

}  // namespace common
