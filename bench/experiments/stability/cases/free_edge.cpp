// 1. Boundary bias: at the free edge of a surface, part of a gather's disc is beyond the edge.
#include <numbers>

#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;
using common::Vec3;

constexpr double radius = 0.1;
constexpr std::size_t texels = 400;

/// Makes a floor of 2 x 2 whose lightmap coordinates are rotated by 30 degrees, so that texels at its edges
/// are cut.
const common::Scene& floor_with_turned_texels() {
    static const common::Scene made = [] {
        common::Scene scene;
        const float c = std::cos(std::numbers::pi_v<float> / 6), s = 0.5f;
        const auto turned = [c, s](float x, float y) {
            return common::Vec2(0.5f + 0.7f * (c * x - s * y), 0.5f + 0.7f * (s * x + c * y));
        };
        const auto floor = scene_builder::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        add(scene,
            scene_builder::with_lightmap_uv(
                floor, {turned(-0.5f, -0.5f), turned(0.5f, -0.5f), turned(0.5f, 0.5f), turned(-0.5f, 0.5f)}),
            scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}

/// Returns points at a distance from the edge x = 1, away from the corners.
std::vector<SurfacePoint> points_at(double distance) {
    return points_across(floor_with_turned_texels(), 0, 1 - distance / 2);
}

/// Sets all texels' areas to that of a whole one.
void forget_clipping(shlm::PreparedTexels& prepared) {
    float whole = 0;
    for (const shlm::TexelGeometry& texel : prepared.geometry) whole = std::max(whole, texel.area);
    for (shlm::TexelGeometry& texel : prepared.geometry)
        if (texel.area > 0) texel.area = whole;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const common::Scene& scene = floor_with_turned_texels();
    constexpr double places[] = {0, 0.1, 0.25, 0.5, 0.75, 1, 1.5};
    const auto bright = [](double) { return 1.0; };
    const double wrong = run.has_mutation("the whole disc counts") ? 1 : 0;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, radius r", places,
                 [&](double t) { return std::max(1 - segment_of_disc(t), wrong); }),
        curve_at("light map, own texel", places, bright),
        curve_at("light map, 4 nearest texels", places, bright),
        curve_at("light map, own texel, areas not clipped", places, bright, Expected::shown)};
    shlm::PreparedTexels clipped = texels_of(scene, texels), whole = clipped;
    forget_clipping(whole);
    if (run.has_mutation("texel areas are not clipped")) clipped = whole;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        common::HitBatch hits;
        irradiate_quad(hits, scene, 0, run.either<std::size_t>(2'000'000, 200'000), generator,
                       always({0, 0, -1}));
        const auto photon_map = photon_map_of(scene, hits, within(scene, radius));
        const auto own = light_map_of<FlatModel>(clipped, hits, shlm::OwnTexel{});
        const auto nearest = light_map_of<FlatModel>(clipped, hits, shlm::NearestTexels{4});
        const auto unclipped = light_map_of<FlatModel>(whole, hits, shlm::OwnTexel{});
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const auto points = points_at(places[i] * radius);
            curves[0].points[i].measured.push_back(mean_irradiance(photon_map, points));
            curves[1].points[i].measured.push_back(mean_irradiance(own, points));
            curves[2].points[i].measured.push_back(mean_irradiance(nearest, points));
            curves[3].points[i].measured.push_back(mean_irradiance(unclipped, points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    10,
    {.name = "free-edge",
     .purpose = "Boundary bias: near the free edge of a surface a photon map's disc hangs over the edge and "
                "reads too little; a light map must not, though its texels are cut there.",
     .scene = "A floor of 2 x 2 under vertical light of 1 W/m^2, r = 0.1; its 400 texels are turned by 30 "
              "degrees. Means over 64 points along the edge.",
     .swept = "distance from the edge / r",
     .measured = "irradiance / truth",
     .theory = "Photon map: 1 - (acos t - t sqrt(1 - t^2)) / pi, the part of the disc that is on the floor. "
               "Light map: 1 with texel areas clipped to the surface.",
     .advice = "No remedy in the photon map: do not trust it within a radius of an edge. The light map clips "
               "every texel against every triangle.",
     .mutations = {"the whole disc counts", "texel areas are not clipped"},
     .run = run});

}  // namespace
}  // namespace bench::stability
