// Known light without a tracer: photons that are placed on surfaces by hand, and the maps that they fill.
#pragma once

#include <random>

#include "bench/setup/scene_builder.h"
#include "photonmap/photon_sinks.h"
#include "shlm/map/sink.h"

namespace bench::stability {

/// The model of a traditional light map: the surface's irradiance alone, without the truncation of a series.
using FlatModel = shlm::TexelModel<0, shlm::ShWeight::normalised>;

template <int Order>
using HarmonicModel = shlm::TexelModel<Order, shlm::ShWeight::radiance>;

/// Seeded once per seed. What is drawn in the same order is the same on every machine.
using Generator = std::mt19937_64;

/// Returns a uniform number in [0, 1) of 24 bits. Distributions of the standard library differ between
/// libraries.
[[nodiscard]] inline float uniform(Generator& generator) {
    return static_cast<float>(generator() >> 40) * 0x1p-24f;
}

/// Adds `count` photons on the quad (scene_builder.h) whose first triangle is `first_triangle`. They are
/// uniform and independent, and together give it 1 W/m^2 if the map's watts_per_flux is 1.
/// `direction(generator)` is the unit direction of travel of a photon.
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

/// Returns a direction function that is constant.
[[nodiscard]] inline auto always(const common::Vec3& direction) {
    return [direction](Generator&) { return direction; };
}

/// Returns a direction function for a uniform hemisphere above a surface with this unit normal.
[[nodiscard]] inline auto diffusely_onto(const common::Vec3& normal) {
    return [frame = common::Frame(normal)](Generator& generator) {
        const float u1 = uniform(generator), u2 = uniform(generator);
        return -frame.to_world(common::sample_cosine_hemisphere(u1, u2));
    };
}

/// Returns the finished map of a sink that takes these hits, with flux in W.
template <common::MapSink Sink>
[[nodiscard]] auto map_of(Sink sink, const common::HitBatch& hits) {
    sink.consume(std::span(&hits, 1));
    return std::move(sink).finish(1.0f);
}

[[nodiscard]] photonmap::FlannPhotonSink::Map photon_map_of(const common::Scene& scene,
                                                            const common::HitBatch& hits,
                                                            const photonmap::GatherSettings& gather);

/// Returns settings for all photons within `radius`, scene units.
[[nodiscard]] photonmap::GatherSettings within(const common::Scene& scene, double radius);

/// Returns settings for the k nearest photons within `max_radius`, scene units.
[[nodiscard]] photonmap::GatherSettings nearest(std::size_t k, double max_radius);

[[nodiscard]] shlm::PreparedTexels texels_of(const common::Scene& scene, std::size_t texels);

/// Returns the quantum for these hits, as if the brightest carried all the light.
[[nodiscard]] shlm::Quantum quantum_of(const common::HitBatch& hits);

/// Builds a light map of the hits. `texels` must outlive it. Each texel shows its own hits, however few,
/// unless `least_hits` is larger. Instantiated in known_light.cpp for each model that is named there.
template <class Model = shlm::PaperModel>
[[nodiscard]] shlm::HarmonicMap<Model> light_map_of(const shlm::PreparedTexels& texels,
                                                    const common::HitBatch& hits, const shlm::Gather& gather,
                                                    std::uint64_t least_hits = 0);

/// Returns the mean over channels and points.
template <common::IrradianceEstimator Map>
[[nodiscard]] double mean_irradiance(const Map& map, std::span<const common::SurfacePoint> points) {
    double sum = 0;
    for (const common::SurfacePoint& point : points) sum += common::mean_component(map.irradiance(point));
    return sum / static_cast<double>(points.size());
}

}  // namespace bench::stability
