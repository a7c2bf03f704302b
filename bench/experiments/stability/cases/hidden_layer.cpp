// A dark surface close behind a lit one: its texels are as close to a point as the point's own.
#include <algorithm>

#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

constexpr double width = 2;
constexpr std::size_t texels_along = 40;
constexpr double texel = width / texels_along;

/// Makes a floor at z = 0, and another one `depth` below it.
common::Scene two_floors(double depth) {
    common::Scene scene = square_floor(width);
    const auto half = static_cast<float>(width / 2), z = static_cast<float>(-depth),
               whole = static_cast<float>(width);
    scene_builder::add(scene, scene_builder::quad({-half, -half, z}, {whole, 0, 0}, {0, whole, 0}),
                       scene_builder::diffuse({0.5f, 0.5f, 0.5f}));
    return scene;
}

/// Returns points all over one texel in the floor's middle, which is like any other.
std::vector<common::SurfacePoint> points_of_a_texel(const common::Scene& scene) {
    constexpr int steps = 8;
    std::vector<common::SurfacePoint> points;
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i)
            points.push_back(floor_point(scene, width, (i + 0.5) / steps * texel, (j + 0.5) / steps * texel));
    return points;
}

/// Returns the fraction of the four nearest texels that belong to the upper floor. Both floors have texels at
/// the same x and y.
double lit_part_of_four(const common::SurfacePoint& point, double depth) {
    std::vector<std::pair<double, double>> near;  // squared distance; 1 above, 0 below
    const double x = point.position.x / texel - 0.5, y = point.position.y / texel - 0.5;
    for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
            const double dx = (std::round(x) + i - x) * texel, dy = (std::round(y) + j - y) * texel;
            near.emplace_back(dx * dx + dy * dy, 1);
            near.emplace_back(dx * dx + dy * dy + depth * depth, 0);
        }
    std::partial_sort(near.begin(), near.begin() + 4, near.end());
    return (near[0].second + near[1].second + near[2].second + near[3].second) / 4;
}

double seen_by_nearest(double depth) {
    double sum = 0;
    const common::Scene scene = two_floors(depth);
    const auto points = points_of_a_texel(scene);
    for (const common::SurfacePoint& point : points) sum += lit_part_of_four(point, depth);
    return sum / static_cast<double>(points.size());
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double depths[] = {0.0005, 0.002, 0.005, 0.01, 0.02, 0.03, 0.05, 0.08};
    std::vector<StabilityCurve> curves = {
        curve_at("light map, 4 nearest texels, as in the paper", depths, seen_by_nearest),
        curve_at("light map, 4 nearest of the own surface", depths, [](double) { return 1.0; }),
        curve_at("light map, bilinear", depths, [](double) { return 1.0; }),
        curve_at("light map, own texel", depths, [](double) { return 1.0; })};
    std::vector<common::Scene> scenes;
    std::vector<shlm::PreparedTexels> prepared;
    for (const double depth : depths) {
        scenes.push_back(two_floors(depth));
        prepared.push_back(texels_of(scenes.back(), 2 * texels_along * texels_along));
    }
    const shlm::NearestTexels of_own_surface{4, !run.has_mutation("texels of any surface")};

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(depths); ++i) {
            common::HitBatch hits;
            irradiate_quad(hits, scenes[i], 0, run.either<std::size_t>(400'000, 100'000), generator,
                           always({0, 0, -1}));
            const auto points = points_of_a_texel(scenes[i]);
            const shlm::Gather gathers[] = {shlm::NearestTexels{4, false}, of_own_surface, shlm::Bilinear{},
                                            shlm::OwnTexel{}};
            for (std::size_t g = 0; g < std::size(gathers); ++g)
                curves[g].points[i].measured.push_back(
                    mean_irradiance(light_map_of<FlatModel>(prepared[i], hits, gathers[g]), points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    33,
    {.name = "hidden-layer",
     .purpose =
         "A floor that lies on another, a panel on a wall, leather over leather: the paper's gather "
         "takes texels of the dark layer behind for the lit one in front, however many hits there are.",
     .scene = "A floor of 2 x 2 with texels of 0.05, irradiated with 1 W/m^2 by 400,000 photons (short form: "
              "100,000); the same floor again below it, without light. Means over 64 points of one texel.",
     .swept = "depth of the hidden layer",
     .measured = "irradiance / that of the lit floor",
     .theory = "Four nearest texels: the part of the four nearest places of both lattices that are of the "
               "upper one. All others: 1.",
     .advice = "The default gather takes texels of the point's own piece of surface and of pieces that share "
               "an edge with it.",
     .mutations = {"texels of any surface"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
