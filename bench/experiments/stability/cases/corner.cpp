// 2. Topological bias: near a corner, a ball around a point of the floor also contains photons of the wall.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

constexpr double radius = 0.1;
constexpr std::size_t texels = 800;
constexpr std::uint32_t floor_triangle = 0, wall_triangle = 2;

/// Makes a floor of 1 x 1 and a wall of 1 x 1 on its edge x = 0.
const common::Scene& corner() {
    static const common::Scene made = [] {
        common::Scene scene;
        const common::Material white = scene_builder::diffuse({1, 1, 1});
        add(scene, scene_builder::quad({0, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}), white);
        add(scene, scene_builder::quad({0, -0.5f, 0}, {0, 1, 0}, {0, 0, 1}), white);
        return scene;
    }();
    return made;
}

/// Assigns all photons to one surface, as a gather does that ignores their surfaces. The light comes down at
/// 45 degrees, so that a photon of the wall counts like one of the floor.
common::HitBatch with_surfaces_forgotten(common::HitBatch hits) {
    for (common::SurfaceId& on : hits.surface) on.triangle = floor_triangle + on.triangle % 2;
    return hits;
}

/// Returns the fraction, on the floor, of the disc of radius 1 around a point at t from the wall.
double part_on_the_floor(double t) {
    return 1 - segment_of_disc(t);
}

/// Returns the wall's contribution: the ball cuts its plane in a disc of radius sqrt(1 - t^2), half of which
/// is above the floor.
double part_on_the_wall(double t) {
    return t >= 1 ? 0 : (1 - t * t) / 2;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const common::Scene& scene = corner();
    constexpr double places[] = {0, 0.1, 0.25, 0.537, 0.75, 0.9, 1.1, 1.5};
    const auto bright = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, normal test", places, part_on_the_floor),
        curve_at("photon map, no normal test", places,
                 [](double t) { return part_on_the_floor(t) + part_on_the_wall(t); }),
        curve_at("light map, own texel", places, bright),
        curve_at("light map, 4 nearest texels", places, bright)};
    const shlm::PreparedTexels prepared = texels_of(scene, texels);

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        common::HitBatch hits;
        const auto slanting = always(common::Vec3(-1, 0, -1).normalized());
        for (const std::uint32_t quad : {floor_triangle, wall_triangle})
            irradiate_quad(hits, scene, quad, run.either<std::size_t>(500'000, 40'000), generator, slanting);
        const common::HitBatch forgotten = with_surfaces_forgotten(hits);
        const auto told_apart =
            photon_map_of(scene, run.has_mutation("photons of both surfaces count") ? forgotten : hits,
                          within(scene, radius));
        const auto not_told_apart = photon_map_of(scene, forgotten, within(scene, radius));
        const common::HitBatch& for_texels =
            run.has_mutation("both surfaces fill the same texels") ? forgotten : hits;
        const auto own = light_map_of<FlatModel>(prepared, for_texels, shlm::OwnTexel{});
        const auto nearest = light_map_of<FlatModel>(prepared, for_texels, shlm::NearestTexels{4});
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const auto points = points_across(scene, floor_triangle, places[i] * radius);
            curves[0].points[i].measured.push_back(mean_irradiance(told_apart, points));
            curves[1].points[i].measured.push_back(mean_irradiance(not_told_apart, points));
            curves[2].points[i].measured.push_back(mean_irradiance(own, points));
            curves[3].points[i].measured.push_back(mean_irradiance(nearest, points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    20,
    {.name = "corner",
     .purpose = "Topological bias in a concave corner: a ball of photons around a point of the floor reaches "
                "the wall. Its photons must not count, and without them the ball is not full.",
     .scene = "A floor and a wall of 1 x 1 under parallel light of 1 W/m^2 on both, r = 0.1, 400 texels "
              "each. Means over 64 points along the corner.",
     .swept = "distance from the corner / r",
     .measured = "irradiance / truth",
     .theory = "Photon map with the normal test: 1 - s, s = (acos t - t sqrt(1 - t^2)) / pi, as at a free "
               "edge. Without: 1 - s + (1 - t^2) / 2, at most 1.180 at t = 2 / sqrt(pi^2 + 4). Light map: 1.",
     .advice = "The normal test, always on, keeps light from going round corners; what is left is the "
               "boundary bias of a free edge. A light map has neither.",
     .mutations = {"photons of both surfaces count", "both surfaces fill the same texels"},
     .run = run});

}  // namespace
}  // namespace bench::stability
