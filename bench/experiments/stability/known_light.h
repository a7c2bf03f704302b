// Light that is known without a tracer: photons put on surfaces by hand, and the maps that they fill.
#pragma once

#include <random>

#include "bench/setup/scene_builder.h"
#include "photonmap/photon_sinks.h"
#include "shlm/map/sink.h"

namespace bench::stability {

/// What a traditional light map stores: the surface's irradiance alone, without error of a series.
using FlatModel = shlm::TexelModel<0, shlm::ShWeight::normalised>;

template <int Order>
using HarmonicModel = shlm::TexelModel<Order, shlm::ShWeight::radiance>;

/// For each seed its own; what is drawn in one order is the same everywhere.
using Generator = std::mt19937_64;

/// In [0, 1), of 24 bits: the standard's distributions differ between libraries.
[[nodiscard]] inline float uniform(Generator& generator) {
    return static_cast<float>(generator() >> 40) * 0x1p-24f;
}

/// Adds `count` photons that fall on the quad (scene_builder.h) whose first triangle is `first_triangle`,
/// uniform and independent, and together irradiate it with 1 W/m^2, if the map's watts_per_flux is 1.
/// `direction(generator)` is the way that each travels, unit.
template <class Direction>
void irradiate_quad(common::HitBatch& hits, const common::Scene& scene, std::uint32_t first_triangle,
                    std::size_t count, Generator& generator, Direction direction) {
    const double area =
        common::triangle_area(scene, first_triangle) + common::triangle_area(scene, first_triangle + 1);
    const auto flux = static_cast<float>(area / static_cast<double>(count));
    hits.reserve(hits.size() + count);
    for (std::size_t i = 0; i < count; ++i) {
        const float s = uniform(generator), t = uniform(generator);
        const common::SurfaceId on = scene_builder::on_quad(first_triangle, s, t);
        const common::Vec3 at = common::position_at(scene, on);
        hits.push_back(at, direction(generator), {flux, flux, flux}, on);
    }
}

/// All the same way.
[[nodiscard]] inline auto always(const common::Vec3& direction) {
    return [direction](Generator&) { return direction; };
}

/// As from a uniform hemisphere above a surface with this unit normal.
[[nodiscard]] inline auto diffusely_onto(const common::Vec3& normal) {
    return [frame = common::Frame(normal)](Generator& generator) {
        const float u1 = uniform(generator), u2 = uniform(generator);
        return -frame.to_world(common::sample_cosine_hemisphere(u1, u2));
    };
}

/// The finished map of a sink that takes these hits; their flux is in W.
template <common::MapSink Sink>
[[nodiscard]] auto map_of(Sink sink, const common::HitBatch& hits) {
    sink.consume(std::span(&hits, 1));
    return std::move(sink).finish(1.0f);
}

[[nodiscard]] photonmap::FlannPhotonSink::Map photon_map_of(const common::Scene& scene,
                                                            const common::HitBatch& hits,
                                                            const photonmap::GatherSettings& gather);

/// All photons within `radius`, world units.
[[nodiscard]] photonmap::GatherSettings within(const common::Scene& scene, double radius);

/// The k nearest photons within `max_radius`, world units.
[[nodiscard]] photonmap::GatherSettings nearest(std::size_t k, double max_radius);

[[nodiscard]] shlm::PreparedTexels texels_of(const common::Scene& scene, std::size_t texels);

/// Units for hits whose brightest has all the light.
[[nodiscard]] shlm::Quantum quantum_of(const common::HitBatch& hits);

/// `texels` must outlive the map. Each texel shows its own light, whatever few hits it has, unless
/// `least_hits` says otherwise. Made in known_light.cpp, once for each model that is named there.
template <class Model = shlm::PaperModel>
[[nodiscard]] shlm::HarmonicMap<Model> light_map_of(const shlm::PreparedTexels& texels,
                                                    const common::HitBatch& hits, const shlm::Gather& gather,
                                                    std::uint64_t least_hits = 0);

/// Mean over the channels and the points.
template <common::IrradianceEstimator Map>
[[nodiscard]] double mean_irradiance(const Map& map, std::span<const common::SurfacePoint> points) {
    double sum = 0;
    for (const common::SurfacePoint& point : points) sum += common::mean_component(map.irradiance(point));
    return sum / static_cast<double>(points.size());
}

}  // namespace bench::stability
