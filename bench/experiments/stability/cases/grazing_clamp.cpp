// 11. Grazing light: what the clamp of the cosine removes from uniform light.
#include <numbers>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {
namespace {

using common::HitBatch;
using common::Vec3;

constexpr double pi = std::numbers::pi, tilt = pi / 3;
constexpr double clamps[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}, ours[] = {common::min_incident_cosine};

/// Photons from one elevation, at all azimuths.
struct Ring {
    double cosine, flux;
};

/// A uniform hemisphere has irradiance 2 c dc at cosine c, here 8 v^7 dv with c = v^4. Grazing light, which
/// carries little flux, is thus sampled by many faint photons, so that noise hardly shows.
Ring uniform_sky(double v) {
    return {v * v * v * v, 8 * std::pow(v, 7)};
}

/// A sky that is uniform up to this cosine and dark above.
constexpr double top_of_low_sky = 0.02;
Ring low_sky(double v) {
    return {top_of_low_sky * std::sqrt(v), 1};
}

/// Makes photons that all arrive at the same point in the middle. Maps then read the sum of their weights,
/// without noise from their positions.
HitBatch light_of(Ring ring_at(double), std::size_t rings, Generator& generator) {
    constexpr int turns = 16;
    const common::SurfaceId middle = scene_builder::on_quad(0, 0.5f, 0.5f);
    HitBatch hits;
    for (std::size_t i = 0; i < rings; ++i) {
        const auto [cosine, flux] =
            ring_at((static_cast<double>(i) + uniform(generator)) / static_cast<double>(rings));
        const auto each = static_cast<float>(flux / static_cast<double>(rings * turns));
        const float turn = uniform(generator);
        for (int k = 0; k < turns; ++k)
            hits.push_back(
                position_at(unit_floor(), middle),
                -common::direction_at(static_cast<float>(cosine), (static_cast<float>(k) + turn) / turns),
                {each, each, each}, middle);
    }
    return hits;
}

/// Returns the sum of flux times `weight(towards the light)`.
template <class Weight>
double sum_of(const HitBatch& hits, Weight weight) {
    double sum = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) sum += hits.flux[i].x * weight(-hits.direction[i]);
    return sum;
}

/// Returns what the weight 1 / cos gives without a clamp; `kernel` is applied to the cosine to the tilted
/// normal.
template <class Kernel>
double unclamped(const HitBatch& hits, const Vec3& normal, Kernel kernel) {
    return sum_of(hits, [&](const Vec3& to) { return kernel(std::max(0.0f, to.dot(normal))) / to.z; });
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const double part = run.has_mutation("the clamp takes all below it") ? 1 : 0.5;
    const bool flux_weight = run.has_mutation("the light map has the flux weight");
    const bool upright = run.has_mutation("the photon map is asked for the surface's own normal");
    const std::size_t rings = run.either<std::size_t>(8192, 1024);
    // Rounding to floats: the finished coefficients of a light map round a few times by 2^-24. The photon
    // map's sum rounds once per photon by at most 2^-24 of the sum so far, which is a random walk.
    const double light_map_rounds = 0x1p-21, walk = 0x1p-24 * std::sqrt(16.0 * static_cast<double>(rings));
    std::vector<StabilityCurve> curves = {
        // Uniform light with the weight 1 / cos has 2 dc. Below e, the clamp removes 2 (1 - c / e) dc, in all
        // e of 2.
        curve_at("order 0, sums of this case's own", clamps, [&](double e) { return part * e; }),
        curve_at(
            "light map, order 0", ours, [](double e) { return e / 2; }, Expected::equal, light_map_rounds),
        // It removes 2 (1 - c / e) k2(c) dc of 2 k2(c) dc, whose integral is 1.
        curve_at(
            "light map, order 2, own normal", ours,
            [](double e) { return (3 * e / 2 + 16 * e * e / 6 + 15 * e * e * e / 12) / 16; }, Expected::equal,
            light_map_rounds),
        // A plane tilted by a reads (1 + cos a) / 2. Near the horizon, half of all azimuths are in front of
        // it: they contribute sin a / pi on average, plus c cos a / 2.
        curve_at(
            "photon map, normal tilted by 60 degrees", ours,
            [](double e) {
                return (e * std::sin(tilt) / pi + e * e * std::cos(tilt) / 6) / ((1 + std::cos(tilt)) / 2);
            },
            Expected::equal, walk),
        // The surface's own irradiance has 2 c dc / m^2 up to m, and lacks the fraction 1 - c / e below e.
        curve_at("light map, what it says it clamped of a low sky", ours,
                 [](double e) { return e * e / 3 / (top_of_low_sky * top_of_low_sky); })};
    const shlm::PreparedTexels texels = texels_of(unit_floor(), 1);
    const common::SurfacePoint point = on_unit_floor(0.5f, 0.5f);
    const common::SurfacePoint tilted = scene_builder::tilted(point, tilt, 0.3);

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const HitBatch hits = light_of(uniform_sky, rings, generator);
        const auto lost = [](double reading, double truth) { return 1 - reading / truth; };
        const double facing = unclamped(hits, point.shading_normal, [](double) { return 1.0; });
        for (std::size_t i = 0; i < std::size(clamps); ++i)
            curves[0].points[i].measured.push_back(lost(
                sum_of(hits, [&](const Vec3& to) { return 1 / std::max<double>(to.z, clamps[i]); }), facing));
        const auto read = [&](const auto& map, const common::SurfacePoint& at) {
            return static_cast<double>(map.irradiance(at).x);
        };
        using Order0 = HarmonicModel<0>;
        using Order0Flux = shlm::TexelModel<0, shlm::ShWeight::flux>;
        const double order_0 = flux_weight
                                   ? read(light_map_of<Order0Flux>(texels, hits, shlm::OwnTexel{}), point)
                                   : read(light_map_of<Order0>(texels, hits, shlm::OwnTexel{}), point);
        curves[1].points[0].measured.push_back(lost(order_0, facing / 4));  // pi Y00^2 = 1 / 4
        curves[2].points[0].measured.push_back(lost(
            read(light_map_of(texels, hits, shlm::OwnTexel{}), point),
            unclamped(hits, point.shading_normal, [](double x) { return clamped_cosine_series(2, x); })));
        // a disc of 1 m^2
        const auto photon_map =
            map_of(photonmap::GridPhotonSink(unit_floor(), within(unit_floor(), 1 / std::sqrt(pi))), hits);
        curves[3].points[0].measured.push_back(
            lost(read(photon_map, upright ? point : tilted),
                 unclamped(hits, tilted.shading_normal, [](double x) { return x; })));

        const HitBatch low = light_of(low_sky, rings, generator);
        shlm::Sink<Order0> sink(texels, shlm::OwnTexel{}, quantum_of(low));
        sink.consume(std::span(&low, 1));
        curves[4].points[0].measured.push_back(sink.accumulator().clamped().discarded_share());
    });
    return curves;
}

const RegisteredCase registered(
    110,
    {.name = "grazing-clamp",
     .purpose = "A hit stands for a directional light of its flux over the cosine of incidence. Near grazing "
                "that has no bound, so the cosine is clamped, and what the clamp takes is missing.",
     .scene = "A floor of 1 x 1 under a uniform sky of 1 W/m^2, all photons in one place; seeds draw their "
              "directions. The last curve: a sky that is bright below 1.15 degrees only.",
     .swept = "clamp e of the cosine (the maps' own is 0.001)",
     .measured = "part of the light that the clamp takes",
     .theory = "Order 0 loses e / 2, order 2 at the surface's own normal 3 e / 32 and terms in e^2, a photon "
               "map 2 e sin a / (pi (1 + cos a)) at a normal tilted by a, and only e^2 / 3 at the surface's "
               "own, which is also what a light map says it clamped: of a sky that ends at cosine m, "
               "(e / m)^2 / 3.",
     .advice = "Nothing to do at the clamp of 0.001: it takes less than 0.05 %. A light map with the "
               "normalised weight has the surface's own irradiance whole; clamped_share in its output says "
               "what one with the radiance weight lacks.",
     .mutations = {"the clamp takes all below it", "the light map has the flux weight",
                   "the photon map is asked for the surface's own normal"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
