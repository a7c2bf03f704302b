// The hits of one block of photons, and the interface of their consumers.
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

/// Arrivals of photons on diffuse surfaces and in their holes, as structure of arrays, in an order that
/// depends only on the block's photons. An arrival is recorded before its reflection: `flux` is the incident
/// flux.
struct HitBatch {
    std::vector<Vec3> position;   ///< world units, on the surface
    std::vector<Vec3> direction;  ///< unit, the way the photon travels: towards the surface
    std::vector<Rgb> flux;        ///< W times the number of photons emitted in the whole run
    std::vector<SurfaceId> surface;
    std::vector<std::uint32_t> photon;  ///< index of the photon, counted from the first of the block

    [[nodiscard]] std::size_t size() const { return position.size(); }

    void clear() { resize(0); }

    void reserve(std::size_t hits) {
        position.reserve(hits);
        direction.reserve(hits);
        flux.reserve(hits);
        surface.reserve(hits);
        photon.reserve(hits);
    }

    /// The values of new elements are undefined.
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

/// Returns whether hit `i` can be stored: one NaN would corrupt a whole map.
[[nodiscard]] inline bool is_finite(const HitBatch& batch, std::size_t i) {
    const Vec3 &at = batch.position[i], &along = batch.direction[i], &flux = batch.flux[i];
    // 0 times any finite value is 0. This takes nine multiplications and no branch.
    return at.x * 0 + at.y * 0 + at.z * 0 + along.x * 0 + along.y * 0 + along.z * 0 + flux.x * 0 +
               flux.y * 0 + flux.z * 0 ==
           0;
}

[[nodiscard]] inline std::size_t count_hits(std::span<const HitBatch> wave) {
    std::size_t hits = 0;
    for (const HitBatch& batch : wave) hits += batch.size();
    return hits;
}

/// Takes the hits of a run, wave after wave. Waves come one at a time, in the order of their photons, and
/// their data are valid only during the call. A sink may use oneTBB inside. What it has stored at the end
/// must not depend on how the batches were cut into waves or on the number of threads.
template <class S>
concept PhotonSink = requires(S& sink, std::span<const HitBatch> wave) {
    { sink.consume(wave) } -> std::same_as<void>;
};

/// A sink that also takes batches from several threads at once, in any order. What it has stored at the end
/// does not depend on the order. So hits are stored while they are in the cache of the thread that traced
/// them.
template <class S>
concept UnorderedSink = PhotonSink<S> && requires(S& sink, const HitBatch& batch) {
    { sink.add(batch) } -> std::same_as<void>;
};

/// A sink that becomes a map for irradiance queries. `watts_per_flux` converts HitBatch::flux to W; `bytes`
/// is its memory while it takes hits, `rejected` the hits that it could not take.
template <class S>
concept MapSink = PhotonSink<S> && requires(S sink, const S& filled, float watts_per_flux) {
    { std::move(sink).finish(watts_per_flux) } -> IrradianceEstimator;
    { filled.bytes() } -> std::same_as<std::size_t>;
    { filled.rejected() } -> std::convertible_to<RejectedHits>;
};

}  // namespace common
