// 6. Texels that a chart's border cuts: what remains of them has few hits, whose noise a lookup may show.
#include "bench/experiments/stability/sparse_hits.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr int texels_along = 20;    // of a lightmap that covers the plane z = 0 from (0, 0) to (1, 1)
constexpr double off_middle = 0.3;  // distance of each point from the middle of its row, in texels
constexpr double hits_per_texel = 200;

/// Makes two charts. Of the texels 0 to 19 along x, the first one covers 0 to 9 and the fraction `left` of
/// texel 10; the second one begins with 12.
common::Scene two_charts(double left) {
    const auto chart = [](double from, double to) {
        const auto low = static_cast<float>(from / texels_along),
                   high = static_cast<float>(to / texels_along);
        return scene_builder::with_lightmap_uv(
            scene_builder::quad({low, 0, 0}, {high - low, 0, 0}, {0, 1, 0}),
            {{low, 0}, {high, 0}, {high, 1}, {low, 1}});
    };
    common::Scene scene;
    add(scene, joined(chart(0, 10 + left), chart(12, texels_along)), scene_builder::diffuse({1, 1, 1}));
    return scene;
}

struct CutChart {
    double left;
    common::Scene scene = two_charts(left);
    shlm::PreparedTexels texels = texels_of(scene, texels_along* texels_along);

    [[nodiscard]] common::HitBatch hits(Generator& generator) const {
        return poisson_hits(scene, hits_per_texel * texels_along * (10 + left), generator);
    }

    /// Returns points in rows well inside; at the border, `texels_from_the_left` is 10 + left.
    [[nodiscard]] std::vector<SurfacePoint> points(double texels_from_the_left, double texels_down) const {
        std::vector<SurfacePoint> points;
        for (int row = 1; row + 2 < texels_along; ++row)
            points.push_back(scene_builder::front_of(
                scene, scene_builder::on_quad(0, static_cast<float>(texels_from_the_left / (10 + left)),
                                              static_cast<float>((row + texels_down) / texels_along))));
        return points;
    }
    [[nodiscard]] std::vector<SurfacePoint> border_points() const {
        return points(10 + left, 0.5 + off_middle);
    }
};

// Hits are independent. So a texel of area a, in whole texels, has the relative variance 1 / (a n) if a whole
// texel gets n hits.

constexpr double of_rows = (1 - off_middle) * (1 - off_middle) + off_middle * off_middle;

/// The point is at `left` beyond the texel's border, which is 1/2 + left beyond the middle of the last whole
/// texel. This is the weight of the cut texel, and it is multiplied by the texel's remaining area.
double variance_of_bilinear(double left) {
    const double whole = 0.5 - left, cut = 0.5 + left, weights = whole + cut * left;
    return of_rows * (whole * whole + cut * cut * left) / (weights * weights);
}

/// Returns the same if weights ignore the remaining area.
double variance_without_areas(double left) {
    const double whole = 0.5 - left, cut = 0.5 + left;
    return of_rows * (whole * whole + cut * cut / left);
}

/// The nearest texels are two of each row, weighted by area: all their hits over all their area.
double variance_of_nearest(double left) {
    return 1 / (2 * (1 + left));
}

/// Returns the mean squared error of a weighted mean of four texels at the border that ignores their
/// remaining areas. The cut ones have the weight `cut`, those of the next row `down`.
double error_without_areas(const CutChart& chart, const shlm::HarmonicMap<FlatModel>& own, double cut,
                           double down) {
    const auto light = [&](double x, double y) {
        std::vector<double> read;
        for (const SurfacePoint& point : chart.points(x, y)) read.push_back(own.irradiance(point).x);
        return read;
    };
    const double cut_middle = 10 + chart.left / 2;
    const auto here = light(9.5, 0.5), here_cut = light(cut_middle, 0.5), next = light(9.5, 1.5),
               next_cut = light(cut_middle, 1.5);
    double sum = 0;
    for (std::size_t row = 0; row < here.size(); ++row)
        sum += square_of_error((1 - down) * ((1 - cut) * here[row] + cut * here_cut[row]) +
                               down * ((1 - cut) * next[row] + cut * next_cut[row]));
    return sum / static_cast<double>(here.size());
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.4};
    const bool without_areas = run.has_mutation("what is left of a texel counts as a whole one");
    std::vector<StabilityCurve> curves = {
        curve_at("light map, bilinear", places, variance_of_bilinear),
        curve_at("light map, bilinear, whole weights", places, variance_without_areas),
        curve_at("light map, 4 nearest texels", places, variance_of_nearest)};
    std::vector<CutChart> charts;
    for (const double left : places) charts.push_back({left});
    const bool count_alike = run.has_mutation("the nearest texels count alike");

    constexpr int draws = 8;  // per seed: a few hits in a few rows determine a variance poorly
    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            for (StabilityCurve& curve : curves) curve.points[i].measured.push_back(0);
            const CutChart& chart = charts[i];
            for (int draw = 0; draw < draws; ++draw) {
                const common::HitBatch hits = chart.hits(generator);
                const auto measure = [&](std::size_t curve, double mean_squared_error) {
                    curves[curve].points[i].measured.back() += hits_per_texel * mean_squared_error / draws;
                };
                const auto own = light_map_of<FlatModel>(chart.texels, hits, shlm::OwnTexel{});
                const double by_distance = error_without_areas(chart, own, 0.5 + chart.left, off_middle);
                const auto error_of = [&](const shlm::Gather& gather) {
                    return mean_of(light_map_of<FlatModel>(chart.texels, hits, gather), chart.border_points(),
                                   square_of_error);
                };
                measure(0, without_areas ? by_distance : error_of(shlm::Bilinear{}));
                measure(1, by_distance);
                measure(2, count_alike ? error_without_areas(chart, own, 0.5, 0.5)
                                       : error_of(shlm::NearestTexels{4}));
            }
        }
    });
    return curves;
}

const RegisteredCase registered(
    61,
    {.name = "cut-texels",
     .purpose = "Texels that a chart's border cuts: a lookup that gives what is left of them the weight of "
                "whole ones shows their noise, as dark and bright fringes along borders.",
     .scene = "A chart whose border cuts a row of texels, under vertical light, 200 hits to a whole texel. "
              "Points on the border.",
     .swept = "part of a texel that is left",
     .measured = "relative variance / that of a whole texel",
     .theory = "A part a has a times the hits. Bilinear weights w = 1/2 - a and c = 1/2 + a, times areas: "
               "0.58 (w^2 + a c^2) / (w + a c)^2; without areas 0.58 (w^2 + c^2 / a). The 4 nearest count by "
               "area: 1 / (2 (1 + a)).",
     .advice = "Nothing to do: all lookups weigh texels by their covered areas.",
     .mutations = {"what is left of a texel counts as a whole one", "the nearest texels count alike"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
