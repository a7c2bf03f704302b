// 5. Blur: the width that the edge of a shadow gets.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

constexpr double width = 8, radius = 1;  ///< a texel is 1 wide
constexpr std::size_t texels = 64;
constexpr int offsets = 16;  ///< of the edge relative to the texels, evenly over a texel, per seed
constexpr int points = 8;    ///< per offset and distance

// Means at distance x from the edge, over all positions of the edge in its texel. Lengths are in texels; x >
// 0 is in the shadow.

/// The texel holds the mean over its width, and its centre is uniformly within half a width: a step convolved
/// with two boxes. This is the probability that two uniform numbers add up to more than 1 + x.
double read_by_own_texel(double x) {
    if (x < 0) return 1 - read_by_own_texel(-x);
    return x < 1 ? (1 - x) * (1 - x) / 2 : 0;
}

/// Bilinear weights are a box convolved with itself, so there are three boxes. This is the probability that
/// three uniform numbers add up to more than 3/2 + x.
double read_bilinearly(double x) {
    if (x < 0) return 1 - read_bilinearly(-x);
    if (x > 1.5) return 0;
    const double rest = 1.5 - x;
    return std::pow(rest, 3) / 6 - (rest > 1 ? std::pow(rest - 1, 3) / 2 : 0);
}

/// Integrates with the midpoint rule over the point's position in its texel.
double read_by_four_nearest(double x) {
    constexpr int steps = 60;
    double sum = 0;
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i) {
            const double across = (i + 0.5) / steps - 0.5, along = (j + 0.5) / steps / 2;
            sum += mean_of_four_nearest(across, along, [&](double column, double) {
                return std::clamp(0.5 - (x + column - across), 0.0, 1.0);  // the texel's lit part
            });
        }
    return sum / steps / steps;
}

/// Returns the mean over points along the edge, at random positions relative to the texels' rows.
template <class Map>
double mean_along(const Map& map, const common::Scene& floor, double x, Generator& generator) {
    std::vector<common::SurfacePoint> asked;
    for (int i = 0; i < points; ++i)
        asked.push_back(floor_point(floor, width, x, 4 * double{uniform(generator)} - 2));
    return mean_irradiance(map, asked);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    static const common::Scene floor = square_floor(width);
    constexpr double places[] = {-1.5, -1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1, 1.5};
    // The integrand jumps where another texel becomes the fourth: the error is 5e-4, compared with 1000
    // steps.
    constexpr double quadrature = 1e-3;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, radius r", places, segment_of_disc),
        curve_at("light map, own texel", places, read_by_own_texel),
        curve_at("light map, bilinear", places, read_bilinearly),
        curve_at("light map, 4 nearest texels", places, read_by_four_nearest, Expected::equal, quadrature)};
    const shlm::PreparedTexels prepared = texels_of(floor, texels);
    const double gathered = run.has_mutation("the radius is a tenth larger") ? 1.1 * radius : radius;
    const shlm::Gather own = run.has_mutation("the own texel is interpolated")
                                 ? shlm::Gather(shlm::Bilinear{})
                                 : shlm::Gather(shlm::OwnTexel{});

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        std::vector<std::vector<double>> sums(curves.size(), std::vector<double>(std::size(places)));
        for (int part = 0; part < offsets; ++part) {
            const double edge = (part + double{uniform(generator)}) / offsets - 0.5;
            common::HitBatch all;
            irradiate_quad(all, floor, 0, run.either<std::size_t>(100'000, 5'000), generator,
                           always({0, 0, -1}));
            const common::HitBatch hits =
                lit_where(all, [&](const common::Vec3& at) { return double{at.x} < edge; });
            const auto add = [&](std::size_t curve, const auto& map) {
                for (std::size_t i = 0; i < std::size(places); ++i)
                    sums[curve][i] += mean_along(map, floor, edge + places[i], generator);
            };
            add(0, photon_map_of(floor, hits, within(floor, gathered)));
            add(1, light_map_of<FlatModel>(prepared, hits, own));
            add(2, light_map_of<FlatModel>(prepared, hits, shlm::Bilinear{}));
            add(3, light_map_of<FlatModel>(prepared, hits, shlm::NearestTexels{4}));
        }
        for (std::size_t curve = 0; curve < curves.size(); ++curve)
            for (std::size_t i = 0; i < std::size(places); ++i)
                curves[curve].points[i].measured.push_back(sums[curve][i] / offsets);
    });
    return curves;
}

const RegisteredCase registered(
    50,
    {.name = "step-edge",
     .purpose = "Blur: the sharp edge of a shadow is as wide as what is gathered, in either method, with "
                "any number of photons.",
     .scene = "A floor with 1 W/m^2 on one side of a straight edge, at 16 places against the texels for "
              "each seed; 8 points at random along it for each.",
     .swept = "distance into the shadow / r, / h",
     .measured = "irradiance / that of the lit side",
     .theory = "Disc: (acos t - t sqrt(1 - t^2)) / pi, from 90 to 10 % within 1.37 r. Own texel: two boxes "
               "of width h convolved, 1.11 h. Bilinear: three, 1.31 h. 4 nearest: their lit parts' mean, "
               "by quadrature, 1.69 h.",
     .advice = "Smaller texels, or radii; a map of its own for light that is sharp, such as caustics. At "
               "equal areas, pi r^2 = h^2, the photon map's edge is 0.78 h wide.",
     .mutations = {"the radius is a tenth larger", "the own texel is interpolated"},
     .run = run});

}  // namespace
}  // namespace bench::stability
