// 16. Ringing: harmonics of a single hard light become negative, and positive on the back.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;
using common::Vec3;

constexpr double width = 2;  ///< of a floor that is one texel

/// If bands 1 and 2 are multiplied by sqrt(3) / 2 and 4/5, the series 1/4 + x/2 + 5/16 (3 x^2 - 1) / 2
/// becomes a square, which is never negative.
double windowed_series(double x) {
    const double root = x + std::numbers::inv_sqrt3;
    return 3.0 / 8 * root * root;
}

struct Light {
    Vec3 towards, normal;
};

/// Draws a light up to 60 degrees off the surface's normal, and a normal at the given angle to the light.
Light light_at(double degrees, Generator& generator) {
    const float height = 0.5f + 0.5f * uniform(generator), turn = uniform(generator);
    const Vec3 towards = common::direction_at(height, turn);
    const auto cosine = static_cast<float>(std::cos(degrees * scene_builder::pi / 180));
    return {towards, common::Frame(towards).to_world(common::direction_at(cosine, uniform(generator)))};
}

/// Makes one photon with all the flux that the floor gets from 1 W/m^2 at normal incidence.
common::HitBatch photon_of(const SurfacePoint& point, const Vec3& towards_light) {
    const auto flux = static_cast<float>(width * width) * towards_light.z;
    common::HitBatch hits;
    hits.push_back(point.position, -towards_light, {flux, flux, flux}, point.surface);
    return hits;
}

/// The answer of a map, the series of its only texel, and that series with factors on its bands.
struct Reading {
    double answer, series, windowed;
};
template <int Order>
Reading read(const shlm::PreparedTexels& texel, const common::HitBatch& hits, const SurfacePoint& point,
             float band_1 = 1, float band_2 = 1) {
    const auto map = light_map_of<HarmonicModel<Order>>(texel, hits, shlm::OwnTexel{});
    auto texel_shown = map.texels().front();
    const auto series = [&] {
        return double{common::mean_component(texel_shown.irradiance(point.shading_normal))};
    };
    const double whole = series();
    for (std::size_t i = 3; i < texel_shown.stored.size(); ++i)
        texel_shown.stored[i] *= i < 12 ? band_1 : band_2;
    return {double{common::mean_component(map.irradiance(point))}, whole, series()};
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    // 122.2 degrees: the minimum of (3 + 16 x + 15 x^2) / 32, -0.0396 at x = -8/15.
    constexpr double angles[] = {0, 30, 60, 75, 90, 104, 122.2, 135, 150, 165, 180};
    constexpr double rounding = 3e-6;
    const auto curve = [&](std::string name, auto of_cosine) {
        return curve_at(
            std::move(name), angles,
            [&](double degrees) { return of_cosine(std::cos(degrees * scene_builder::pi / 180)); },
            Expected::equal, rounding);
    };
    const auto cut_off = [](int order) {
        return [=](double x) { return std::max(0.0, clamped_cosine_series(order, x)); };
    };
    std::vector<StabilityCurve> curves = {
        curve("photon map", [](double x) { return std::max(0.0, x); }),
        curve("light map, L1", cut_off(1)),
        curve("light map, L2", cut_off(2)),
        curve("light map, L4", cut_off(4)),
        curve("L2, nothing cut off", [](double x) { return clamped_cosine_series(2, x); }),
        curve("L2, windowed by 1, 0.866, 0.8", windowed_series)};
    const common::Scene floor = square_floor(width);
    const shlm::PreparedTexels texel = texels_of(floor, 1);
    // A disc of the floor's area divides by the same area as the texel.
    const auto gather = within(floor, width / std::sqrt(scene_builder::pi));
    const bool cut = !run.has_mutation("what is below zero is not cut off");
    const bool tilted = !run.has_mutation("photons are read for the surface's own normal");
    const float band_1 = run.has_mutation("the window leaves band 1 as it is") ? 1.0f : 0.8660254f;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(angles); ++i) {
            const Light light = light_at(angles[i], generator);
            SurfacePoint point = floor_point(floor, width, 0, 0);
            const common::HitBatch hits = photon_of(point, light.towards);
            if (tilted) point.shading_normal = light.normal;
            const double by_photon_map =
                common::mean_component(photon_map_of(floor, hits, gather).irradiance(point));
            point.shading_normal = light.normal;
            const Reading second = read<2>(texel, hits, point, band_1, 0.8f);
            const double values[] = {by_photon_map,
                                     read<1>(texel, hits, point).answer,
                                     cut ? second.answer : second.series,
                                     read<4>(texel, hits, point).answer,
                                     second.series,
                                     second.windowed};
            for (std::size_t c = 0; c < curves.size(); ++c) curves[c].points[i].measured.push_back(values[c]);
        }
    });
    return curves;
}

const RegisteredCase registered(
    160,
    {.name = "ringing",
     .purpose = "Ringing: of one hard light the truncated harmonics give too much at the peak, less than "
                "nothing beyond the horizon, and light on the back.",
     .scene = "One texel under one photon of parallel light, 1 W/m^2 on a plane that faces it. The light is "
              "up to 60 degrees off the surface's normal, its direction and the shading normal's are the "
              "seed's.",
     .swept = "angle between the shading normal and the light, degrees",
     .measured = "irradiance, W/m^2",
     .theory = "Truth, and the photon map: max(0, x), x the angle's cosine. Light map: max(0, series), 1/4 + "
               "x/2 (L1), (3 + 16 x + 15 x^2) / 32 (L2), 3/32 P_4(x) less (L4). Windowed: 3/8 (x + 1 / "
               "sqrt(3))^2.",
     .advice =
         "What is below zero is cut off, always. Windowing is not used: it takes the light from the "
         "back, but 6.7 % from the peak and leaves 1.7 times the error over all. A map of more than one "
         "light hides it.",
     .mutations = {"what is below zero is not cut off", "photons are read for the surface's own normal",
                   "the window leaves band 1 as it is"},
     .run = run});

}  // namespace
}  // namespace bench::stability
