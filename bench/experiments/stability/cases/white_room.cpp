// 17. White walls: light that nothing absorbs.
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

// Between the first two albedos, so few photons would be terminated that a run may have none.
constexpr double albedos[] = {0.99, 0.9995, 0.9999, 1};
constexpr float white_share = 1.0f / 128;  ///< of the light
constexpr std::uint32_t white_triangles = 12;

/// Makes two closed boxes, each with a light. The second is black and has most of the light, so that few
/// photons of a block have long paths.
common::Scene white_and_black_room(float albedo) {
    common::Scene scene = lit_box(albedo);
    for (const scene_builder::Mesh& wall : scene_builder::box_walls({3, -1, -1}, {5, 1, 1}))
        add(scene, wall, scene_builder::diffuse({0, 0, 0}));
    scene.point_light[0].intensity *= white_share;
    const float rest = 1 - white_share;
    scene.point_light.push_back({{4, 0, 0}, {rest, rest, rest}});
    return scene;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const double limit = run.has_mutation("there is no limit") ? 1e9 : common::max_events;
    const bool forgets = run.has_mutation("given up photons are not counted");
    const auto albedo_of = [](double place) { return double{static_cast<float>(place)}; };
    const auto given_up = [&](double place) { return std::pow(albedo_of(place), limit); };
    const auto stored = [&](double place) {
        const double albedo = albedo_of(place);
        return albedo == 1 ? limit / common::max_events
                           : (1 - given_up(place)) / (1 - albedo) / common::max_events;
    };
    // At each arrival, roulette rounds a photon's flux twice. Some photons slip through where walls meet: at
    // most as many as in far-from-origin, 5.2 x 2^-23 of them in a box within [-1, 1].
    constexpr double leaks = common::max_events * 6 * 0x1p-23,
                     rounding = common::max_events * 0x1p-23 + leaks;
    std::vector<StabilityCurve> curves = {
        curve_at("given up / photons", albedos, given_up, Expected::equal, leaks),
        curve_at("photon map: light / (4096 x power)", albedos, stored, Expected::equal, rounding),
        curve_at("light map: light / (4096 x power)", albedos, stored, Expected::equal, rounding),
        curve_at("not accounted for / photons", albedos, [](double) { return 0.0; })};
    const shlm::PreparedTexels texels = texels_of(white_and_black_room(1), 1200);

    run.for_each_seed([&](std::uint64_t seed) {
        for (std::size_t i = 0; i < std::size(albedos); ++i) {
            const auto [hits, report] =
                traced(white_and_black_room(static_cast<float>(albedos[i])), seed,
                       {.photons = common::photons_per_block * run.either<std::uint64_t>(8, 1)});
            // The black walls end each of their photons at the first arrival.
            const auto in_black = static_cast<double>(std::count_if(
                hits.surface.begin(), hits.surface.end(),
                [](const common::SurfaceId& surface) { return surface.triangle >= white_triangles; }));
            const double in_white = static_cast<double>(report.fates.emitted) - in_black;
            const double power = common::mean_component(hits.flux[0]), most = in_white * common::max_events;
            const common::PhotonFates& fates = report.fates;
            const auto ended = static_cast<double>(fates.missed + fates.escaped + fates.absorbed +
                                                   (forgets ? 0 : fates.given_up));
            curves[0].points[i].measured.push_back(static_cast<double>(fates.given_up) / in_white);
            curves[1].points[i].measured.push_back((light_in_photons(hits) / power - in_black) / most);
            curves[2].points[i].measured.push_back((light_in_texels(texels, hits) / power - in_black) / most);
            curves[3].points[i].measured.push_back((static_cast<double>(fates.emitted) - ended) / in_white);
        }
    });
    return curves;
}

const RegisteredCase registered(
    172,
    {.name = "white-room",
     .purpose = "In a closed room that absorbs nothing, photons never end: the tracer would not either.",
     .scene =
         "A closed box of a swept albedo with a light inside, and beside it a black one with most of the "
         "light, whose photons do not count. Seeds draw all photons.",
     .swept = "albedo",
     .measured = "part",
     .theory = "After 4096 arrivals a photon is given up: albedo^4096 of them, which have brought "
               "(1 - albedo^4096) / (1 - albedo) times the power by then. Emitted = missed + escaped + "
               "absorbed + given up.",
     .advice = "Give walls an albedo below 0.999: beyond it light is missing that was given up, as the count "
               "of photons given up says.",
     .mutations = {"there is no limit", "given up photons are not counted"},
     .run = run});

}  // namespace
}  // namespace bench::stability
