// 3. A texel that a wall crosses: it mixes the light of both rooms.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr double width = 2;
constexpr std::size_t texels = 100;
constexpr double texel = 0.2;
/// The radius of a disc with the area of a texel.
const double radius = texel / std::sqrt(std::numbers::pi);

/// A floor, and the position where light ends on it.
struct Rooms {
    common::Scene scene;
    shlm::PreparedTexels prepared;
    float light_ends;  ///< x
};

Rooms with_texels(common::Scene scene, float light_ends) {
    shlm::PreparedTexels prepared = texels_of(scene, texels);
    return {std::move(scene), std::move(prepared), light_ends};
}

/// Makes a floor where the fraction `f` of a texel's width is on the lit side.
Rooms on_one_chart(double f) {
    return with_texels(square_floor(width), static_cast<float>(f * texel));
}

/// Makes the floor of each room as its own mesh with its own texels; the lit room comes first.
Rooms on_two_charts(double f) {
    const auto light_ends = static_cast<float>(f * texel);
    common::Scene scene;
    const common::Material white = scene_builder::diffuse({1, 1, 1});
    add(scene, scene_builder::quad({-1, -1, 0}, {1 + light_ends, 0, 0}, {0, 2, 0}), white);
    add(scene, scene_builder::quad({light_ends, -1, 0}, {1 - light_ends, 0, 0}, {0, 2, 0}), white);
    return with_texels(std::move(scene), light_ends);
}

/// Returns points along the middle of the dark part of the texel, at x = (1 + f) / 2 of its width.
std::vector<SurfacePoint> dark_points_of_one_chart(const Rooms& rooms, double f) {
    return points_across(rooms.scene, 0, 0.5 + (1 + f) / 2 * texel / width);
}
std::vector<SurfacePoint> dark_points_of_two_charts(const Rooms& rooms, double f) {
    const double dark_width = 1 - f * texel;
    return points_across(rooms.scene, 2, (1 - f) / 2 * texel / dark_width);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double parts[] = {0.1, 0.3, 0.5, 0.7, 0.9};
    std::vector<StabilityCurve> curves = {
        curve_at("light map, own texel", parts, [](double f) { return f; }),
        // At (1 + f) / 2 of the texel, the next texel, which is dark, has the weight f / 2.
        curve_at("light map, bilinear", parts, [](double f) { return f * (1 - f / 2); }),
        curve_at("light map, own texel, charts end at the wall", parts, [](double) { return 0.0; }),
        curve_at("light map, bilinear, charts end at the wall", parts, [](double) { return 0.0; }),
        curve_at("photon map, disc as large as a texel", parts,
                 [](double f) { return segment_of_disc((1 - f) / 2 * texel / radius); })};
    std::vector<Rooms> one_chart, two_charts;
    for (const double f : parts) {
        one_chart.push_back(on_one_chart(f));
        two_charts.push_back(on_two_charts(f));
    }
    const bool undivided = run.has_mutation("the chart runs under the wall");
    const double gathered = run.has_mutation("the disc is twice as wide") ? 2 * radius : radius;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const auto photons = run.either<std::size_t>(500'000, 40'000);
        for (std::size_t i = 0; i < std::size(parts); ++i) {
            const Rooms &together = one_chart[i], &apart = two_charts[i];
            common::HitBatch all, in_lit_room;
            irradiate_quad(all, together.scene, 0, photons, generator, always({0, 0, -1}));
            const common::HitBatch hits =
                lit_where(all, [&](const common::Vec3& at) { return at.x < together.light_ends; });
            const auto points = dark_points_of_one_chart(together, parts[i]);
            const auto add_light_map = [&](std::size_t curve, const auto& prepared, const auto& photons_of,
                                           const shlm::Gather& gather, const auto& asked) {
                curves[curve].points[i].measured.push_back(
                    mean_irradiance(light_map_of<FlatModel>(prepared, photons_of, gather), asked));
            };
            add_light_map(0, together.prepared, hits, shlm::OwnTexel{}, points);
            add_light_map(1, together.prepared, hits, shlm::Bilinear{}, points);
            if (undivided) {
                add_light_map(2, together.prepared, hits, shlm::OwnTexel{}, points);
                add_light_map(3, together.prepared, hits, shlm::Bilinear{}, points);
            } else {
                irradiate_quad(in_lit_room, apart.scene, 0, photons / 2, generator, always({0, 0, -1}));
                const auto beyond = dark_points_of_two_charts(apart, parts[i]);
                add_light_map(2, apart.prepared, in_lit_room, shlm::OwnTexel{}, beyond);
                add_light_map(3, apart.prepared, in_lit_room, shlm::Bilinear{}, beyond);
            }
            const auto photon_map = photon_map_of(together.scene, hits, within(together.scene, gathered));
            curves[4].points[i].measured.push_back(mean_irradiance(photon_map, points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    31, {.name = "straddling-texel",
         .purpose = "A wall runs across a row of texels: the dark room's part of them reads the lit room's "
                    "light.",
         .scene = "A floor of 2 x 2 with 10 x 10 texels, irradiated with 1 W/m^2 on one side of the wall. "
                  "Means over 64 points in the middle of the dark part of the row.",
         .swept = "part of the texel's width on the lit side, f",
         .measured = "irradiance / that of the lit room",
         .theory = "Own texel: f, the texel's mean. Bilinear: f (1 - f / 2). Either with charts that end at "
                   "the wall: 0. Photon map with pi r^2 = h^2: s((1 - f) h / 2 r), s the disc's part on the "
                   "lit side.",
         .advice = "Give the rooms charts of their own that end at the wall, and ask the own texel or the "
                   "bilinear gather. The nearest texels in space see across, as the photon map does, "
                   "and so do blocks of fewer than 100 hits in one chart.",
         .mutations = {"the chart runs under the wall", "the disc is twice as wide"},
         .run = run});

}  // namespace
}  // namespace bench::stability
