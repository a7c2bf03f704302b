// 7. Overlapping lightmap coordinates: two surfaces share texels, and each shows the light of the other.
#include <numbers>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr double radius = 0.05;  // of the photon map
constexpr std::size_t texels_of_a_quad = 40 * 40;
constexpr std::uint32_t lit_quad = 0, dark_quad = 2;  // first triangles

/// Makes two quads of 1 x 1 in one mesh. Each has half of the lightmap's width, and shares the fraction
/// `overlap` of it with the other.
common::Scene two_quads(double overlap, float apart) {
    const auto half_from = [](float left) {
        return std::vector<common::Vec2>{{left, 0}, {left + 0.5f, 0}, {left + 0.5f, 1}, {left, 1}};
    };
    const auto quad_at = [](float x) { return scene_builder::quad({x, 0, 0}, {1, 0, 0}, {0, 1, 0}); };
    common::Scene scene;
    add(scene,
        joined(scene_builder::with_lightmap_uv(quad_at(0), half_from(0)),
               scene_builder::with_lightmap_uv(quad_at(apart),
                                               half_from(static_cast<float>(0.5 - 0.5 * overlap)))),
        scene_builder::diffuse({1, 1, 1}));
    return scene;
}

/// Returns points all over a quad except for `margin`, evenly spaced along the lightmap's u.
std::vector<SurfacePoint> points_on(const common::Scene& scene, std::uint32_t quad, double margin,
                                    Generator& generator) {
    constexpr int count = 1000;
    std::vector<SurfacePoint> points;
    for (int i = 0; i < count; ++i) {
        const double s = (i + double{uniform(generator)}) / count, t = uniform(generator);
        const auto inside = [&](double at) { return static_cast<float>(margin + (1 - 2 * margin) * at); };
        points.push_back(scene_builder::front_of(scene, scene_builder::on_quad(quad, inside(s), inside(t))));
    }
    return points;
}

/// The scene for one overlap, and the width of its texels on the quads.
struct Overlap {
    common::Scene scene;
    shlm::LightmapUv uv;
    shlm::PreparedTexels texels, automatic;  ///< by the coordinates, and by face where these overlap
    double texel_width;

    Overlap(double overlap, float apart, shlm::TexelPlacement remedy)
        : scene(two_quads(overlap, apart)),
          uv(shlm::find_lightmap_uv(scene).front()),
          texels(scene, std::span(&uv, 1), 2 * texels_of_a_quad),
          automatic(scene, std::span(&uv, 1), 2 * texels_of_a_quad, remedy),
          texel_width((2 - overlap) / texels.layout.regions()[0].width) {}

    /// Limits the area of each texel to that of a single quad.
    void count_one_surface() {
        const double whole = texel_width / texels.layout.regions()[0].height;
        for (shlm::TexelGeometry& texel : texels.geometry)
            texel.area = std::min(texel.area, static_cast<float>(whole));
    }
};

// Where both quads use a texel, it has the light of one and the area of two: 1/2. At an end of the overlap, a
// texel may be cut at the fraction p of its width: one quad covers all of it, the other p. It reads 1 / (1 +
// p) or p / (1 + p). Compared with texels that end there, this is a difference of p (1 - p) / (2 (1 + p))
// texels over the first quad. It is at most 0.086 for each of the two ends.
constexpr double largest_by_cut_texels = 2 * 0.0858;

/// The nearest texels are those whose centre is near. The centre of a shared texel lies between the quads,
/// where no lookup reaches. The lit quad sees the fraction 1 - overlap that has its own texels, as far as the
/// lookup reaches: four widths of the largest texel, and shared ones have twice the area.
double seen_by_nearest(double overlap, double texel_width) {
    if (overlap == 1) return 0;
    const double from_border =
        (4 * std::numbers::sqrt2 - 1) * texel_width;  // half to 3/2 inside, last middle
    return overlap == 0 ? 1 : std::min(1.0, 1 - overlap + from_border);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {0, 0.1, 0.25, 0.5, 0.75, 0.9, 1};
    std::vector<StabilityCurve> curves = {
        curve_at("overlap that is found / area", places, [](double o) { return o; }),
        curve_at("photon map, dark quad", places, [](double) { return 0.0; }),
        curve_at("photon map, lit quad", places, [](double) { return 1.0; }),
        curve_at("light map, dark quad, own texel", places, [](double o) { return o / 2; }),
        curve_at("light map, lit quad, own texel", places, [](double o) { return 1 - o / 2; }),
        curve_at("light map, lit quad, 4 nearest texels", places, [](double) { return 0.0; }),
        curve_at("light map by face, dark quad", places, [](double) { return 0.0; }),
        curve_at("light map by face, lit quad", places, [](double) { return 1.0; })};
    std::vector<Overlap> overlaps;
    const auto remedy = run.has_mutation("coordinates are used though they overlap")
                            ? shlm::TexelPlacement::uv
                            : shlm::TexelPlacement::automatic;
    for (std::size_t i = 0; i < std::size(places); ++i) {
        Overlap& overlap = overlaps.emplace_back(
            places[i], run.has_mutation("the quads are in one place") ? 0.0f : 5.0f, remedy);
        // The overlap is found by sample points, 128 or more per width of a quad. Each end of the overlap and
        // of the quad is known to half their distance, and so is the diagonal between its triangles.
        curves[0].points[i].allowed = 3.0 / 128;
        curves[0].points[i].measured = {overlap.uv.overlapping_area / overlap.uv.area};
        curves[3].points[i].allowed = curves[4].points[i].allowed =
            largest_by_cut_texels * overlap.texel_width;
        curves[5].points[i].predicted = seen_by_nearest(places[i], overlap.texel_width);
        curves[5].points[i].allowed = 0.7 * overlap.texel_width;
        if (run.has_mutation("a shared texel has the area of one surface")) overlap.count_one_surface();
    }

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const auto& [scene, uv, texels, automatic, width] = overlaps[i];
            common::HitBatch hits;
            irradiate_quad(hits, scene, lit_quad, run.either<std::size_t>(80'000, 20'000), generator,
                           always({0, 0, -1}));
            const auto photon_map = photon_map_of(scene, hits, within(scene, radius));
            const auto own = light_map_of<FlatModel>(texels, hits, shlm::OwnTexel{});
            const auto nearest = light_map_of<FlatModel>(texels, hits, shlm::NearestTexels{4, false});
            const auto by_face = light_map_of<FlatModel>(automatic, hits, shlm::OwnTexel{});
            const auto lit = points_on(scene, lit_quad, 0, generator),
                       dark = points_on(scene, dark_quad, 0, generator);
            curves[1].points[i].measured.push_back(mean_irradiance(photon_map, dark));
            curves[2].points[i].measured.push_back(
                mean_irradiance(photon_map, points_on(scene, lit_quad, radius, generator)));
            curves[3].points[i].measured.push_back(mean_irradiance(own, dark));
            curves[4].points[i].measured.push_back(mean_irradiance(own, lit));
            curves[5].points[i].measured.push_back(mean_irradiance(nearest, lit));
            curves[6].points[i].measured.push_back(mean_irradiance(by_face, dark));
            curves[7].points[i].measured.push_back(mean_irradiance(by_face, lit));
        }
    });
    return curves;
}

const RegisteredCase registered(
    70,
    {.name = "overlapping-coordinates",
     .purpose = "Lightmap coordinates that overlap: two surfaces share texels, and light shows where none "
                "is. Files whose coordinates are made for repeating textures are full of it.",
     .scene = "Two quads of 1 x 1 in one mesh, far from each other, one under vertical light of 1 W/m^2. "
              "Their coordinates share a part of the lightmap. 40 texels to a unit.",
     .swept = "part of each quad's coordinates that overlaps",
     .measured = "irradiance / that on the lit quad",
     .theory = "A shared texel has the light of one quad and the area of both: dark quad o/2, lit quad 1 "
               "- o/2. The middle of a shared texel is between the quads, where the 4 nearest are not "
               "looked for: black. Photon map, and texels by face: 0 and 1.",
     .advice = "Nothing to do: overlap is found before tracing, and such surfaces have texels by face. With "
               "--texels uv, render and compare warn of it.",
     .mutations = {"the quads are in one place", "a shared texel has the area of one surface",
                   "coordinates are used though they overlap"},
     .run = run});

}  // namespace
}  // namespace bench::stability
