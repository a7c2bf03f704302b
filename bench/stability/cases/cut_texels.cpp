// 6. Texels that a chart's border cuts: what is left of them has few hits, whose noise a lookup may show.
#include "bench/stability/sparse_hits.h"
#include "bench/stability/stability_case.h"

namespace bench {
namespace {

using common::SurfacePoint;

constexpr int texels_along = 20;    // of a lightmap that is as large as the plane z = 0 from (0, 0) to (1, 1)
constexpr double off_middle = 0.3;  // of its row of texels: how far each point lies, in texels
constexpr double hits_per_texel = 200;

/// Of the texels 0 ... 19 along x the first chart covers 0 to 9 and part `left` of the 10th, the second one
/// those from 12.
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

    /// At the border, in rows well inside.
    [[nodiscard]] std::vector<SurfacePoint> points() const {
        std::vector<SurfacePoint> points;
        for (int row = 1; row + 2 < texels_along; ++row)
            points.push_back(scene_builder::front_of(
                scene,
                scene_builder::on_quad(0, 1, static_cast<float>((row + 0.5 + off_middle) / texels_along))));
        return points;
    }
};

// Hits are independent, so a texel of area a, in whole texels, with n hits to a whole one has the relative
// variance 1 / (a n).

/// The point is `left` past the texel's border, 1/2 + left past the middle of the last whole one: as much as
/// that is the cut one's weight, whatever is left of it. Both rows have their own weights.
double variance_of_bilinear(double left) {
    const double of_rows = (1 - off_middle) * (1 - off_middle) + off_middle * off_middle;
    const double cut = 0.5 + left, whole = 1 - cut;
    return of_rows * (whole * whole + cut * cut / left);
}

/// The nearest are the two of both rows, and count by area: all their hits over all their area.
double variance_of_nearest(double left) {
    return 1 / (2 * (1 + left));
}

double square_of_error(double irradiance) {
    return (irradiance - 1) * (irradiance - 1);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.4};
    const bool whole = run.has_mutation("what is left of a texel has a whole one's hits");
    std::vector<StabilityCurve> curves = {
        curve_at("light map, bilinear", places,
                 [&](double left) { return whole ? 0.58 * 0.5 : variance_of_bilinear(left); }),
        curve_at("light map, 4 nearest texels", places, variance_of_nearest)};
    std::vector<CutChart> charts;
    for (const double left : places) charts.push_back({left});
    const shlm::Gather nearest = run.has_mutation("the nearest texels are looked up in the lightmap")
                                     ? shlm::Gather(shlm::Bilinear{})
                                     : shlm::NearestTexels{4};

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const CutChart& chart = charts[i];
            const common::HitBatch hits = chart.hits(generator);
            const auto measure = [&](StabilityCurve& curve, const shlm::Gather& gather) {
                const auto map = light_map_of<FlatModel>(chart.texels, hits, gather);
                curve.points[i].measured.push_back(hits_per_texel *
                                                   mean_of(map, chart.points(), square_of_error));
            };
            measure(curves[0], shlm::Bilinear{});
            measure(curves[1], nearest);
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
     .theory = "A part a has a times the hits. Bilinear: 0.58 ((1/2 - a)^2 + (1/2 + a)^2 / a). The 4 nearest "
               "count by area: 1 / (2 (1 + a)).",
     .advice = "Look up the nearest texels in space, the default. For bilinear, lay borders of charts on "
               "borders of texels.",
     .mutations = {"what is left of a texel has a whole one's hits",
                   "the nearest texels are looked up in the lightmap"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench
