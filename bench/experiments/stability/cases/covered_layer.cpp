// 2. Topological bias: a panel close above a floor, within the radius of a gather.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

constexpr double radius = 0.1;
constexpr std::uint32_t floor_triangle = 0, panel_triangle = 2;

/// Makes a floor of 1 x 1, and a panel at this height above its half x < 0.
common::Scene floor_and_panel(double height) {
    common::Scene scene;
    const common::Material white = scene_builder::diffuse({1, 1, 1});
    add(scene, scene_builder::quad({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}), white);
    add(scene, scene_builder::quad({-0.5f, -0.5f, static_cast<float>(height)}, {0.5f, 0, 0}, {0, 1, 0}),
        white);
    return scene;
}

/// Makes vertical light of 1 W/m^2 that falls on the panel and, where there is none, on the floor.
common::HitBatch irradiate(const common::Scene& scene, std::size_t photons, Generator& generator) {
    common::HitBatch on_floor, hits;
    irradiate_quad(on_floor, scene, floor_triangle, photons, generator, always({0, 0, -1}));
    hits = lit_where(on_floor, [](const common::Vec3& at) { return at.x > 0; });
    irradiate_quad(hits, scene, panel_triangle, photons / 2, generator, always({0, 0, -1}));
    return hits;
}

/// Returns the lit fraction of the floor's disc around a point at `x` radii from the panel's edge.
double read_from_floor(double x) {
    return 1 - segment_of_disc(x);
}

/// The ball around that point cuts the panel, `height` radii above it, in a smaller disc. Returns the area of
/// this disc that is on the panel, relative to the floor's disc.
double read_from_panel(double x, double height) {
    const double disc_sq = 1 - height * height;
    return disc_sq * segment_of_disc(x / std::sqrt(disc_sq));
}

/// A panel and the data for measurements at it.
struct Panel {
    double height;  ///< in radii
    common::Scene scene;
    common::RayScene rays;
    common::CoveringSurfaces covers;

    explicit Panel(double in_radii)
        : height(in_radii), scene(floor_and_panel(in_radii * radius)), rays(scene), covers(rays) {}
};

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {-1.5, -0.9, -0.6, -0.3, -0.1, 0.1, 0.3, 0.6, 0.9, 1.5};
    const Panel close(0.01), high(0.5);
    const auto told = [](const Panel& panel) {
        return [&panel](double x) {
            return read_from_floor(x) + (x > 0 ? read_from_panel(x, panel.height) : 0);
        };
    };
    const auto not_told = [&close](double x) {
        return read_from_floor(x) + read_from_panel(x, close.height);
    };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, panel at r / 100", places, told(close)),
        curve_at("photon map, panel at r / 2", places, told(high)),
        curve_at("compact photon map, panel at r / 100", places, told(close)),
        curve_at("photon map that looks at normals alone, panel at r / 100", places, not_told)};
    const bool unknown = run.has_mutation("what covers a point is not known");
    const bool alone = run.has_mutation("the panel's photons never count");

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const auto photons = run.either<std::size_t>(500'000, 40'000);
        const auto measure = [&](std::size_t curve, const Panel& panel, auto sink_of) {
            common::HitBatch hits = irradiate(panel.scene, photons, generator);
            if (alone) hits = lit_where(hits, [](const common::Vec3& at) { return at.z == 0; });
            const auto map = map_of(sink_of(panel), hits);
            for (std::size_t i = 0; i < std::size(places); ++i)
                curves[curve].points[i].measured.push_back(mean_irradiance(
                    map, points_across(panel.scene, floor_triangle, 0.5 + places[i] * radius)));
        };
        const auto flann = [&](const Panel& panel) {
            return photonmap::FlannPhotonSink(panel.scene, within(panel.scene, radius),
                                              unknown ? nullptr : &panel.covers);
        };
        measure(0, close, flann);
        measure(1, high, flann);
        measure(2, close, [&](const Panel& panel) {
            return photonmap::CompactPhotonSink(panel.scene, within(panel.scene, radius),
                                                unknown ? nullptr : &panel.covers);
        });
        measure(3, close, [](const Panel& panel) {
            return photonmap::FlannPhotonSink(panel.scene, within(panel.scene, radius));
        });
    });
    return curves;
}

const RegisteredCase registered(
    23,
    {.name = "covered-layer",
     .purpose = "Topological bias of layers: a panel close over a floor, a shelf over the next, tiles over a "
                "slab. All face the same way, so the normal test cannot tell their photons apart, and what "
                "lies in the dark under one of them would read its light.",
     .scene = "A floor of 1 x 1, half of it under a panel, and vertical light of 1 W/m^2 from above; "
              "r = 0.1. Means over 64 points along the panel's edge.",
     .swept = "distance from the panel's edge / r, negative under the panel",
     .measured = "irradiance / that of the open floor",
     .theory = "1 - s(x), s(t) = (acos t - t sqrt(1 - t^2)) / pi, from the floor's disc; beside the panel "
               "also (1 - h^2) s(x / sqrt(1 - h^2)) from the disc in which the ball cuts the panel at height "
               "h r. Under it nothing comes from the panel, unless normals alone are looked at.",
     .advice = "Always on in the program: photons count only as far up as nothing covers the point, which a "
               "ray along its normal tells. What is left under the panel is the step edge of its shadow. "
               "Photons of a panel beside the point do count: without them it would read half at the edge.",
     .mutations = {"what covers a point is not known", "the panel's photons never count"},
     .run = run});

}  // namespace
}  // namespace bench::stability
