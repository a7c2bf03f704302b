// 18. A scene far from the origin, where floats are coarse.
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

using common::Vec3;

constexpr double side = 2, albedo = 0.5;  // of lit_box
constexpr double distances[] = {1, 10, 100, 1e3, 1e4}, beyond[] = {1e5, 2e5, 4e5, 1e6};

/// A box that is rotated, so that its walls are rounded, and moved by this many of its sides.
struct MovedBox {
    common::Scene scene;
    shlm::PreparedTexels texels;

    explicit MovedBox(double sides)
        : scene(scene_builder::moved(lit_box(static_cast<float>(albedo)), scene_builder::skew_rotation(),
                                     Vec3(1, 1, 1) * static_cast<float>(sides * side))),
          texels(texels_of(scene, 600)) {}
};

/// Rounding affects a point on a wall, corner + u edge_u + v edge_v, and the origin of the next ray. Each is
/// rounded along each axis, three times in all, by half a unit of the last place. A photon within that
/// distance of a neighbouring wall may start behind it; such points form four strips along the edges of a
/// wall. It is then lost before its next arrival: the sum of (albedo (1 - q))^k lacks q albedo / (1 -
/// albedo).
double most_lost(double sides) {
    const double last_place = std::ldexp(1.0, std::ilogb((sides + 1) * side) - 23);
    const double strip = std::sqrt(3.0) * 1.5 * last_place;
    return 4 * strip / side * albedo / (1 - albedo);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const double farther = run.has_mutation("the box is 64 times as far away") ? 64 : 1;
    std::vector<StabilityCurve> curves = {curve_at("photon map", distances, most_lost, Expected::at_most),
                                          curve_at("light map", distances, most_lost, Expected::at_most),
                                          curve_at("photon map, farther", beyond, most_lost, Expected::shown),
                                          curve_at("light map, farther", beyond, most_lost, Expected::shown)};
    const MovedBox at_origin(0);
    std::vector<MovedBox> judged_boxes, boxes_beyond;
    for (const double sides : distances) judged_boxes.emplace_back(farther * sides);
    for (const double sides : beyond) boxes_beyond.emplace_back(sides);
    run.for_each_seed([&](std::uint64_t seed) {
        const auto photons = common::photons_per_block * run.either<std::uint64_t>(64, 2);
        const auto stored = [&](const MovedBox& box) {
            const common::HitBatch hits = traced(box.scene, seed, {.photons = photons}).hits;
            return std::array{light_in_photons(hits), light_in_texels(box.texels, hits)};
        };
        const auto all = stored(at_origin);
        const auto measure = [&](std::size_t first, std::span<const MovedBox> boxes) {
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const auto there = stored(boxes[i]);
                for (std::size_t method = 0; method < 2; ++method)
                    curves[first + method].points[i].measured.push_back(1 - there[method] / all[method]);
            }
        };
        measure(0, judged_boxes);
        measure(2, boxes_beyond);
    });
    return curves;
}

const RegisteredCase registered(
    181,
    {.name = "far-from-origin",
     .purpose = "Far from the origin positions are coarse: photons start behind walls and are lost.",
     .scene = "A skew closed box of albedo 0.5 with a point light, moved away from the origin; the same "
              "photons as "
              "at the origin. Seeds draw them.",
     .swept = "distance from the origin / side of the box, along each axis",
     .measured = "part of the light that is lost",
     .theory =
         "At most 4 strips along the edges of each wall, as wide as its places are rounded: 1.5 sqrt(3) "
         "last places of the coordinates. Rays start 16 x 2^-23 of the largest coordinate off their "
         "surface, which is the whole box from 5 x 10^5 sides on.",
     .advice =
         "Keep scenes within 10^4 of their size from the origin, or move them there; what is thinner than "
         "2 x 10^-6 of the largest coordinate does not stop light.",
     .mutations = {"the box is 64 times as far away"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
