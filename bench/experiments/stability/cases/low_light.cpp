// 11. Light that comes only from just above the horizon.
#include <numbers>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr double degree = std::numbers::pi / 180, tilt = 20 * degree;
constexpr double elevations[] = {90, 30, 10, 3, 1, 0.3, 0.03};
constexpr double radius = 0.1, clamp = common::min_incident_cosine;
constexpr int points_each_way = 8;

const common::Scene& plain_floor() {
    static const common::Scene made = [] {
        common::Scene scene;
        add(scene, scene_builder::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}

/// Returns the centres of the texels, with normals tilted by this angle.
std::vector<SurfacePoint> points_tilted_by(double angle) {
    std::vector<SurfacePoint> points;
    for (int i = 0; i < points_each_way; ++i)
        for (int j = 0; j < points_each_way; ++j)
            points.push_back(scene_builder::tilted(
                scene_builder::front_of(
                    plain_floor(), scene_builder::on_quad(0, (static_cast<float>(i) + 0.5f) / points_each_way,
                                                          (static_cast<float>(j) + 0.5f) / points_each_way)),
                angle, 0));
    return points;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const bool upright = run.has_mutation("the photon map does not read the tilt");
    const bool by_sums = run.has_mutation("the weight is not normalised");
    const auto own = [](double e) { return std::sin(e * degree); };
    const auto leaning = [](double e) { return std::sin(e * degree + tilt); };
    // Let x be the cosine of incidence. A light that gives the surface 1 W/m^2 gives 1 / x to a plane that
    // faces it, and leaning(e) / x at a normal that is tilted towards it. The clamp replaces 1 / x by 1 /
    // clamp if that is less.
    const auto clamped = [&](double e) { return std::min(1.0, own(e) / clamp); };
    constexpr double rounding = 1e-5;  // of a photon map's sum of some thousand floats
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, own normal", elevations, clamped),
        curve_at("photon map, tilted by 20 degrees", elevations, clamped),
        curve_at("light map, normalised, own normal", elevations, [](double) { return 1.0; }),
        // The series of the shape is scaled from k2(x) to 1. The factor is below its bound, as k2(x) > x.
        curve_at("light map, normalised, tilted", elevations,
                 [&](double e) {
                     return clamped_cosine_series(2, leaning(e)) / clamped_cosine_series(2, own(e)) /
                            (leaning(e) / own(e));
                 }),
        curve_at("light map, radiance, own normal", elevations,
                 [&](double e) { return clamped(e) * clamped_cosine_series(2, own(e)) / own(e); }),
        curve_at("light map, radiance, tilted", elevations,
                 [&](double e) { return clamped(e) * clamped_cosine_series(2, leaning(e)) / leaning(e); })};
    for (StabilityCurve& curve : curves)
        for (StabilityPoint& point : curve.points) point.allowed = rounding * point.predicted;
    const shlm::PreparedTexels texels = texels_of(plain_floor(), points_each_way * points_each_way);
    const auto straight = points_tilted_by(0), tilted = points_tilted_by(tilt);

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(elevations); ++i) {
            const double e = elevations[i] * degree,
                         tilted_truth = leaning(elevations[i]) / own(elevations[i]);
            common::HitBatch hits;
            irradiate_quad(hits, plain_floor(), 0, run.either<std::size_t>(400'000, 30'000), generator,
                           always({-static_cast<float>(std::cos(e)), 0, -static_cast<float>(std::sin(e))}));
            const auto measure = [&](std::size_t first, const auto& map, const auto& tilted_points) {
                curves[first].points[i].measured.push_back(mean_irradiance(map, straight));
                curves[first + 1].points[i].measured.push_back(mean_irradiance(map, tilted_points) /
                                                               tilted_truth);
            };
            measure(0, map_of(photonmap::GridPhotonSink(plain_floor(), within(plain_floor(), radius)), hits),
                    upright ? straight : tilted);
            using Normalised = shlm::TexelModel<2, shlm::ShWeight::normalised>;
            const auto radiance = light_map_of(texels, hits, shlm::OwnTexel{});
            if (by_sums)
                measure(2, radiance, tilted);
            else
                measure(2, light_map_of<Normalised>(texels, hits, shlm::OwnTexel{}), tilted);
            measure(4, radiance, tilted);
        }
    });
    return curves;
}

const RegisteredCase registered(
    111,
    {.name = "low-light",
     .purpose = "Where all light comes from near the horizon, as at sunset or along a lamp's wall, harmonics "
                "cannot tell just above it from just below.",
     .scene = "A floor of 2 x 2 under parallel light that brings 1 W/m^2 to it, from a swept elevation; "
              "shading normals straight up, and tilted towards the light by 20 degrees. Photon map of radius "
              "0.1, light map of order 2 with 64 texels. Seeds place the photons; means over 64 points.",
     .swept = "elevation of the light, degrees",
     .measured = "irradiance / truth",
     .theory =
         "x = sin(elevation), y = sin(elevation + tilt), k2(x) = (3 + 16 x + 15 x^2) / 32. Photon map: "
         "1, and x / 0.001 below the clamp. Light map: k2(x) / x of the truth with the radiance "
         "weight, k2(y) / y at the tilted normal, both x / 0.001 of that below the clamp; normalised 1, "
         "and k2(y) x / (k2(x) y) at the tilted normal.",
     .advice =
         "Prefer the normalised weight: the surface's own normal is exact at any elevation. With normal "
         "maps under low light it reads too little, where the radiance weight is within a tenth: "
         "there use a photon map. Below 0.06 degrees a photon map loses light to its clamp.",
     .mutations = {"the photon map does not read the tilt", "the weight is not normalised"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
