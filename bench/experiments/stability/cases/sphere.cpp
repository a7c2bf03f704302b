// 2. Topological bias on a sphere: there is none in parallel light, so a sphere cannot reveal it.
#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "common/tracer/ray_scene.h"

namespace bench::stability {
namespace {

using common::Vec3;

constexpr float reach = 1.1f;  ///< photons extend slightly farther from the top than this

/// Makes a sphere of radius 1, whose facets have no edge longer than longest_edge.
const common::Scene& sphere() {
    static const common::Scene made = [] {
        common::Scene scene;
        add(scene, scene_builder::sphere({0, 0, 0}, 1, 6), scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}
constexpr double longest_edge = 0.04;

/// Makes one photon in each cell of a grid over the unit square, at random within the cell. Such even photons
/// have so little noise that bias shows. `ray(u1, u2)` returns the origin and direction of a photon's ray,
/// and `direction(normal)` the direction in which it arrives. Together they carry `power`, W.
template <class Ray, class Direction>
common::HitBatch light(const common::RayScene& rays, int cells, double power, Generator& generator, Ray ray,
                       Direction direction) {
    const auto flux = static_cast<float>(power / cells / cells);
    common::HitBatch hits;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const float u1 = (static_cast<float>(i) + uniform(generator)) / static_cast<float>(cells);
            const float u2 = (static_cast<float>(j) + uniform(generator)) / static_cast<float>(cells);
            const auto [from, along] = ray(u1, u2);
            if (const auto on = rays.nearest(from, along))
                hits.push_back(common::position_at(rays.scene(), *on),
                               direction(sphere().geometric_normal[on->triangle]), {flux, flux, flux}, *on);
        }
    return hits;
}

/// Makes light of 1 W/m^2 that comes straight down onto the top.
common::HitBatch parallel_light(const common::RayScene& rays, int cells, Generator& generator) {
    // The chord s belongs to the distance sin a from the axis, where s = 2 sin(a / 2).
    const float widest = reach * std::sqrt(1 - reach * reach / 4);
    const Vec3 down(0, 0, -1);
    return light(
        rays, cells, scene_builder::pi * widest * widest, generator,
        [&](float u1, float u2) {
            const common::Vec2 at = common::sample_disc(u1, u2) * widest;
            return std::pair(Vec3(at.x, at.y, 2), down);
        },
        [&](const Vec3&) { return down; });
}

/// Makes light from all sides with 1 W/m^2 everywhere.
common::HitBatch even_light(const common::RayScene& rays, int cells, Generator& generator) {
    const float lowest = 1 - reach * reach / 2;
    return light(
        rays, cells, scene_builder::pi * reach * reach, generator,
        [&](float u1, float u2) {
            const Vec3 out = common::direction_at(1 - (1 - lowest) * u1, u2);
            return std::pair(out * 2, -out);
        },
        [&](const Vec3& normal) { return diffusely_onto(normal)(generator); });
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double radii[] = {0.1, 0.2, 0.35, 0.6, 1};
    // The part of a sphere within s of one of its points has the area pi s^2 (Archimedes). In parallel light,
    // a photon's weight compensates the density of photons at its angle, so the estimate is that area. In
    // light from all sides, a photon at s counts (1 + cos a) / 2 = 1 - s^2 / 4 on average, and the mean of
    // s^2 is r^2 / 2.
    const bool as_cylinder = run.has_mutation("a sphere is taken for a cylinder");
    const bool flat = run.has_mutation("photons are taken for those of a plane");
    // A flat equilateral facet of edge e has 1 - 5 e^2 / 24 R^2 of the area of the sphere above it.
    constexpr double allowed = longest_edge * longest_edge / 4;
    std::vector<StabilityCurve> curves = {
        curve_at(
            "photon map, parallel light", radii, [&](double r) { return as_cylinder ? 1 + r * r / 32 : 1; },
            Expected::equal, allowed),
        // Cosines below the clamp e of the divisor reduce the estimate by e / 2.
        curve_at(
            "photon map, light from all sides", radii, [&](double r) { return flat ? 1 : 1 - r * r / 8; },
            Expected::equal, allowed + common::min_incident_cosine / 2)};
    const common::RayScene rays(sphere());
    common::SurfacePoint top =
        scene_builder::front_of(sphere(), rays.nearest({1e-3f, 1e-3f, 2}, {0, 0, -1}).value());
    top.shading_normal = {0, 0, 1};

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const int cells = run.either(600, 150);
        const auto in_parallel =
            photon_map_of(sphere(), parallel_light(rays, cells, generator), within(sphere(), 1));
        const auto in_even = photon_map_of(sphere(), even_light(rays, cells, generator), within(sphere(), 1));
        for (std::size_t i = 0; i < std::size(radii); ++i) {
            const auto gather = within(sphere(), radii[i]);
            const auto read = [&](const auto& map) {
                return double{common::mean_component(map.with_gather(gather).irradiance(top))};
            };
            curves[0].points[i].measured.push_back(read(in_parallel));
            curves[1].points[i].measured.push_back(read(in_even));
        }
    });
    return curves;
}

const RegisteredCase registered(
    22,
    {.name = "sphere",
     .purpose = "Topological bias on a sphere in parallel light is nothing at any radius: who tests on a "
                "sphere, or a dome, does not see what a cylinder or a corner does.",
     .scene = "The top of a sphere of radius R, under parallel light of 1 W/m^2 straight onto it, or even "
              "light from all sides.",
     .swept = "radius of the gather / R",
     .measured = "irradiance / truth",
     .theory = "In parallel light 1: what is within r of a point of a sphere has the area pi r^2 "
               "(Archimedes). In even light, as photons are read by their angle, 1 - r^2 / 8 R^2.",
     .advice = "Test on corners, edges and cylinders.",
     .mutations = {"a sphere is taken for a cylinder", "photons are taken for those of a plane"},
     .run = run});

}  // namespace
}  // namespace bench::stability
