// 8. Empty texels: with few hits, some texels have none and are black.
#include "bench/experiments/stability/panels.h"
#include "bench/experiments/stability/sparse_hits.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

/// Returns the mean of the four nearest texels if those without hits were left out; all have the same area.
double mean_without_empty_ones(const SparseFloor& floor, const shlm::HarmonicMap<FlatModel>& own) {
    double sum = 0;
    int blocks = 0;
    for (int j = 0; j + 1 < SparseFloor::texels_along; ++j)
        for (int i = 0; i + 1 < SparseFloor::texels_along; ++i, ++blocks) {
            double light = 0;
            int lit = 0;
            for (const auto& [x, y] : {std::pair(i, j), {i + 1, j}, {i, j + 1}, {i + 1, j + 1}}) {
                const float irradiance = own.irradiance(floor.middle_of_texel(x, y)).x;
                light += irradiance;
                lit += irradiance > 0;
            }
            if (lit > 0) sum += light / lit;
        }
    return sum / blocks;
}

/// For n hits per texel on average, a texel is lit with probability 1 - e^-n, and then has 1 / (1 - e^-n) on
/// average. This is also the mean over those of four texels that are lit, if any is: (1 - e^-4n) / (1 -
/// e^-n).
double mean_of_the_lit(double n) {
    return 1 + std::exp(-n) + std::exp(-2 * n) + std::exp(-3 * n);
}

double dark(double irradiance) {
    return irradiance == 0 ? 1 : 0;
}

double itself(double irradiance) {
    return irradiance;
}

double dark_in_blocks(double n) {
    return mean_over_blocks(n, shlm::default_least_hits, SparseFloor::levels, dark);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const SparseFloor floor;
    constexpr double places[] = {0.1, 0.2, 0.4, 0.7, 1, 2, 4};
    // Ends where 0.018 of the points are dark: the number of fewer is far from normally distributed.
    const auto places_of_four = std::span(places).first(5);
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, 20 nearest: dark", places, [](double) { return 0.0; }),
        curve_at("photon map, 20 nearest: mean", places, one),
        curve_at("light map, own texel: dark", places, [](double n) { return std::exp(-n); }),
        curve_at("light map, 4 nearest: dark", places_of_four, [](double n) { return std::exp(-4 * n); }),
        curve_at("light map, 4 nearest: mean", places, one),
        curve_at("light map, empty ones left out: mean", places, mean_of_the_lit),
        curve_at("light map, in blocks of 100 hits: dark", places, dark_in_blocks, Expected::at_most),
        curve_at("light map, in blocks of 100 hits: mean", places, one)};
    const std::vector<SurfacePoint> among_four = floor.points_among_four(), all = floor.middles_of_texels(),
                                    middle = floor.points_in_the_middle();
    const std::uint64_t in_blocks =
        run.has_mutation("empty texels are not filled") ? 0 : shlm::default_least_hits;
    const bool leave_out = run.has_mutation("empty texels do not count");
    const auto gather = run.has_mutation("the photon map looks as far as a texel reaches")
                            ? within(floor.scene, 0.5 / SparseFloor::texels_along)
                            : nearest(20, 0.5);

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const common::HitBatch hits = floor.hits(places[i], generator);
            const auto photon_map = photon_map_of(floor.scene, hits, gather);
            const auto own = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{});
            const auto four = light_map_of<FlatModel>(floor.texels, hits, shlm::NearestTexels{4});
            const auto blocks = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{}, in_blocks);
            const double without_empty = mean_without_empty_ones(floor, own);
            curves[0].points[i].measured.push_back(mean_of(photon_map, middle, dark));
            curves[1].points[i].measured.push_back(mean_of(photon_map, middle, itself));
            curves[2].points[i].measured.push_back(mean_of(own, among_four, dark));
            if (i < places_of_four.size())
                curves[3].points[i].measured.push_back(mean_of(four, among_four, dark));
            curves[4].points[i].measured.push_back(leave_out ? without_empty
                                                             : mean_of(four, among_four, itself));
            curves[5].points[i].measured.push_back(without_empty);
            curves[6].points[i].measured.push_back(mean_of(blocks, all, dark));
            curves[7].points[i].measured.push_back(mean_of(blocks, all, itself));
        }
    });
    return curves;
}

bool in_shadow(double x, double y) {
    return (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) < 0.04;
}

/// Draws truth, the 50 nearest photons, the 4 nearest texels alone, and in blocks, side by side. There are 3
/// hits per texel, except in a round shadow.
std::optional<common::Image> picture() {
    const SparseFloor floor;
    Generator generator(1);
    const common::HitBatch offered = floor.hits(3, generator);
    common::HitBatch hits;
    for (std::size_t i = 0; i < offered.size(); ++i)
        if (!in_shadow(offered.position[i].x, offered.position[i].y))
            hits.push_back(offered.position[i], offered.direction[i], offered.flux[i], offered.surface[i]);
    const auto photon_map = photon_map_of(floor.scene, hits, nearest(50, 0.5));
    const auto alone = light_map_of<FlatModel>(floor.texels, hits, shlm::NearestTexels{4});
    const auto blocks =
        light_map_of<FlatModel>(floor.texels, hits, shlm::NearestTexels{4}, shlm::default_least_hits);

    return panels_side_by_side<4>([&](double x, double y) -> std::array<common::Rgb, 4> {
        const SurfacePoint point = on_unit_floor(static_cast<float>(x), static_cast<float>(y));
        const common::Rgb truth(in_shadow(x, y) ? 0.0f : 1.0f);
        return {truth, photon_map.irradiance(point), alone.irradiance(point), blocks.irradiance(point)};
    });
}

const RegisteredCase registered(
    81,
    {.name = "empty-texels",
     .purpose = "Texels that no hit has met are black, as long as each shows what it has itself. To leave "
                "them out of a mean makes dark places too bright.",
     .scene = "A floor of 1 x 1 with 64 x 64 texels under vertical light of 1 W/m^2, and so few hits that "
              "each texel has a Poisson number of them. Pictures: truth, 50 nearest photons, 4 nearest "
              "texels alone and in blocks, 3 hits to a texel.",
     .swept = "hits to a texel, on average: n",
     .measured = "part that reads 0; mean of irradiance / truth",
     .theory =
         "Black: e^-n of the own texels, e^-4n of the 4 nearest, no gather of the k nearest photons; in "
         "blocks of 100 hits those whose parent has 100, which is one in 1e11. Means are right, but "
         "those without the empty texels: 1 + e^-n + e^-2n + e^-3n.",
     .advice = "Nothing to do: blocks of texels share their light until they hold 100 hits, and none of it "
               "is made or lost. /h0 after a method's name shows the texels themselves.",
     .mutations = {"empty texels do not count", "empty texels are not filled",
                   "the photon map looks as far as a texel reaches"},
     .run = run,
     .logarithmic_swept = true,
     .picture = picture});

}  // namespace
}  // namespace bench::stability
