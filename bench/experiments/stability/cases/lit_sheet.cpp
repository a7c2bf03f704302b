// 3. A sheet that is lit from one side: its dark side must stay dark.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;
using common::Vec3;

/// Makes a sheet of 1 x 1 that is visible and lit from both sides; each side has one texel.
const common::Scene& sheet() {
    static const common::Scene made = [] {
        common::Scene scene;
        add(scene, scene_builder::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
            scene_builder::double_sided(scene_builder::diffuse({1, 1, 1})));
        return scene;
    }();
    return made;
}

/// Returns the middle of the dark side.
SurfacePoint from_below() {
    return common::surface_point_at(sheet(), scene_builder::on_quad(0, 0.5f, 0.5f), {0, 0, 1});
}

/// Returns the point as if the texel had no sides: on the lit side, with the normal of the dark one.
SurfacePoint with_sides_forgotten(SurfacePoint point) {
    point.front = true;
    point.geometric_normal = -point.geometric_normal;
    return point;
}

double cosine_of(double degrees) {
    return std::cos(degrees * scene_builder::pi / 180);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double angles[] = {0, 20, 36, 48, 60, 70, 76, 80};
    const auto dark = [](double) { return 0.0; };
    // Light that gives the sheet 1 W/m^2 at cosine of incidence c gives 1 / c to a plane that faces it. The
    // normal of the dark side has the cosine -c to it.
    const auto leak_of_order = [](int order) {
        return [order](double degrees) {
            const double c = cosine_of(degrees);
            return std::max(0.0, clamped_cosine_series(order, -c)) / c;
        };
    };
    constexpr double rounding = 3e-6;
    std::vector<StabilityCurve> curves = {curve_at("photon map", angles, dark),
                                          curve_at("light map, L2, own texel", angles, dark),
                                          curve_at("light map, L2, 4 nearest texels", angles, dark),
                                          curve_at("light map, L2, one texel for both sides", angles,
                                                   leak_of_order(2), Expected::equal, rounding),
                                          curve_at("light map, L1, one texel for both sides", angles,
                                                   leak_of_order(1), Expected::equal, rounding)};
    const shlm::PreparedTexels prepared = texels_of(sheet(), 2);
    const SurfacePoint dark_side = from_below(), forgotten = with_sides_forgotten(dark_side);
    const SurfacePoint asked = run.has_mutation("both sides share a texel") ? forgotten : dark_side;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(angles); ++i) {
            const Vec3 towards_light =
                common::direction_at(static_cast<float>(cosine_of(angles[i])), uniform(generator));
            common::HitBatch hits;
            irradiate_quad(hits, sheet(), 0, 256, generator, always(-towards_light));
            common::HitBatch for_photon_map = hits;
            if (run.has_mutation("photons come through the sheet"))
                for (Vec3& direction : for_photon_map.direction) direction.z = -direction.z;
            const auto add = [&](std::size_t curve, const auto& map, const SurfacePoint& point) {
                curves[curve].points[i].measured.push_back(mean_irradiance(map, std::span(&point, 1)));
            };
            add(0, photon_map_of(sheet(), for_photon_map, within(sheet(), 0.3)), dark_side);
            const auto own = light_map_of<HarmonicModel<2>>(prepared, hits, shlm::OwnTexel{});
            add(1, own, asked);
            add(2, light_map_of<HarmonicModel<2>>(prepared, hits, shlm::NearestTexels{4}), dark_side);
            add(3, own, forgotten);
            add(4, light_map_of<HarmonicModel<1>>(prepared, hits, shlm::OwnTexel{}), forgotten);
        }
    });
    return curves;
}

const RegisteredCase registered(
    32,
    {.name = "lit-sheet",
     .purpose = "A sheet that is lit from one side: a texel that keeps the light of both would show a "
                "ghost of it on the dark side, as the truncated series does not end at the horizon.",
     .scene = "A double-sided sheet of one texel a side under parallel light of 1 W/m^2 on its upper "
              "side, from an azimuth that the seed chooses, asked from below.",
     .swept = "angle of incidence, degrees",
     .measured = "irradiance / that of the lit side",
     .theory = "0. With one texel for both sides max(0, k(-c)) / c at incidence cosine c, with the clamped "
               "cosine's series k(x) = 1/4 + x/2 (L1) + (15 x^2 - 5) / 32 (L2): 6.25 % of the light at "
               "normal incidence, more at grazing.",
     .advice = "Double-sided surfaces have texels of their own on both sides, always on; a photon's side "
               "is known by its direction.",
     .mutations = {"both sides share a texel", "photons come through the sheet"},
     .run = run});

}  // namespace
}  // namespace bench::stability
