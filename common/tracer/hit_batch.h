// The hits of one block of photons, and what a consumer of hits looks like.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "common/scene/surface_point.h"

namespace common {

/// Arrivals of photons on diffuse surfaces, structure of arrays, in an order that depends on the photons
/// alone. Each arrival is recorded before its own reflection: `flux` is what the photon carries towards the
/// surface.
struct HitBatch {
    std::vector<Vec3> position;   ///< world units, on the surface
    std::vector<Vec3> direction;  ///< unit, the way the photon travels: towards the surface
    std::vector<Rgb> flux;        ///< W times the number of photons emitted in the whole run
    std::vector<SurfaceId> surface;

    [[nodiscard]] std::size_t size() const { return position.size(); }

    void clear() {
        position.clear();
        direction.clear();
        flux.clear();
        surface.clear();
    }

    void reserve(std::size_t hits) {
        position.reserve(hits);
        direction.reserve(hits);
        flux.reserve(hits);
        surface.reserve(hits);
    }

    void push_back(const Vec3& at, const Vec3& travelling, const Rgb& carried, const SurfaceId& on) {
        position.push_back(at);
        direction.push_back(travelling);
        flux.push_back(carried);
        surface.push_back(on);
    }
};

/// Whether hit `i` can be stored: one NaN would spoil a whole map.
[[nodiscard]] inline bool is_finite(const HitBatch& batch, std::size_t i) {
    return is_finite(batch.position[i]) && is_finite(batch.direction[i]) && is_finite(batch.flux[i]);
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

/// A sink that becomes a map which can be asked for irradiance. `watts_per_flux` turns HitBatch::flux into W;
/// `bytes` is what it holds while it takes hits.
template <class S>
concept MapSink = PhotonSink<S> && requires(S sink, float watts_per_flux) {
    std::move(sink).finish(watts_per_flux);
    { sink.bytes() } -> std::same_as<std::size_t>;
};

}  // namespace common
