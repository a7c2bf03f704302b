// 6. Texel seams: a lookup in the lightmap does not cross the places where the lightmap is cut.
#include <algorithm>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr int texels_along = 20;  // of each chart, which is 1 x 1
constexpr double texel_width = 1.0 / texels_along;
constexpr double slope = 0.9;               // of the irradiance 1 + slope x, W/m^2 per unit of length
constexpr double off_middle = 0.3;          // distance of each point from the middle of its row, in texels
constexpr double radius = 2 * texel_width;  // of the photon map

/// Makes a floor that is smooth to the eye, but cut at x = 0 into two charts.
const common::Scene& cut_floor() {
    static const common::Scene made = [] {
        common::Scene scene;
        for (const float left : {-1.0f, 0.0f})
            add(scene, scene_builder::quad({left, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}

/// Places one photon at random in each of `cells` x `cells` cells of a chart, which has less noise than
/// independent photons.
void irradiate_chart(common::HitBatch& hits, std::uint32_t chart, int cells, Generator& generator) {
    const float width = 1 / static_cast<float>(cells);
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const float s = (static_cast<float>(i) + uniform(generator)) * width;
            const float t = (static_cast<float>(j) + uniform(generator)) * width;
            const common::SurfaceId on = scene_builder::on_quad(2 * chart, s, t);
            const common::Vec3 at = common::position_at(cut_floor(), on);
            const float flux = static_cast<float>(1 + slope * at.x) * width * width;
            hits.push_back(at, {0, 0, -1}, {flux, flux, flux}, on);
        }
}

/// Returns points at x = `place` texels from the cut, in rows well inside.
std::vector<SurfacePoint> points_at(double place) {
    const double x = place * texel_width;
    std::vector<SurfacePoint> points;
    for (int row = 5; row < texels_along - 5; ++row)
        points.push_back(scene_builder::front_of(
            cut_floor(), scene_builder::on_quad(x < 0 ? 0 : 2, static_cast<float>(x < 0 ? 1 + x : x),
                                                static_cast<float>((row + 0.5 + off_middle) * texel_width))));
    return points;
}

// Errors are in units of texel_width * slope. A texel holds its mean, which for a linear function is the
// value at its centre. So an error is the distance to the centre of the texels that answer.

double middle_of_texel(double place) {
    return std::floor(place) + 0.5;
}

/// The lookup is linear between the centres of texels, but not across the cut: within half a texel of it,
/// only the own texel counts.
double error_of_bilinear(double place) {
    return std::abs(place) < 0.5 ? middle_of_texel(place) - place : 0;
}

/// Let d be the distance from the middle of the own column, and `off_middle` that from the middle of the row.
/// The nearest texels are the own one and the next one in both directions. The fourth is the diagonal one, at
/// (1 - d)^2 + (1 - off_middle)^2, or the one on the far side, at (1 + d)^2 + off_middle^2, whichever is
/// nearer. With the former the mean is the value at the border, with the latter that at the own centre.
double error_of_nearest(double place) {
    const double middle = middle_of_texel(place), border = std::round(place);
    return (std::abs(place - middle) < 0.25 - off_middle / 2 ? middle : border) - place;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const common::Scene& scene = cut_floor();
    // Places on both sides of every jump.
    std::vector<double> places = {0.02, 0.2, 0.38, 0.42, 0.5, 0.58, 0.62, 0.8, 0.98, 1.02, 1.2, 1.38};
    for (std::size_t i = 0; i < 12; ++i) places.push_back(-places[i]);
    std::sort(places.begin(), places.end());
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, radius of 2 texels", places, [](double) { return 0.0; }),
        curve_at("light map, own texel", places, [](double p) { return middle_of_texel(p) - p; }),
        curve_at("light map, bilinear", places, error_of_bilinear),
        curve_at("light map, 4 nearest texels", places, error_of_nearest)};
    const shlm::PreparedTexels texels = texels_of(scene, 2 * texels_along * texels_along);
    const shlm::Gather own = shlm::OwnTexel{}, bilinear = shlm::Bilinear{},
                       nearest = run.has_mutation("the nearest texels are looked up in the lightmap")
                                     ? bilinear
                                     : shlm::Gather(shlm::NearestTexels{4});

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        common::HitBatch hits;
        irradiate_chart(hits, 0, run.either(400, 160), generator);
        const std::size_t left = hits.size();
        irradiate_chart(hits, 1, run.either(400, 160), generator);
        shlm::Sink<FlatModel> sink(texels, own, quantum_of(hits));
        sink.add(hits);
        if (run.has_mutation("the photon map has charts")) hits.resize(left);
        const auto photon_map = photon_map_of(scene, hits, within(scene, radius));
        const auto measure = [&](StabilityCurve& curve, const auto& map) {
            for (StabilityPoint& point : curve.points) {
                const double truth = 1 + slope * point.at * texel_width;
                point.measured.push_back((mean_irradiance(map, points_at(point.at)) - truth) /
                                         (slope * texel_width));
            }
        };
        measure(curves[0], photon_map);
        measure(curves[1], sink.finish(1, own, 0));
        measure(curves[2], sink.finish(1, bilinear, 0));
        measure(curves[3], sink.finish(1, nearest, 0));
    });
    return curves;
}

const RegisteredCase registered(
    60,
    {.name = "texel-seams",
     .purpose = "Texel seams: two charts that lie apart in the lightmap meet on one smooth surface, and "
                "smooth light jumps there if a lookup stays in its chart.",
     .scene = "A floor under light that grows linearly along x, 1 + 0.9 x W/m^2, cut into two charts at x = "
              "0, 20 texels of width h to a unit. Photons by seed, one in each cell of a fine grid.",
     .swept = "place across the cut / h",
     .measured = "error / (h |grad E|)",
     .theory = "A texel holds the light of its middle. Own texel: a jump of 1 at every border of texels. "
               "Bilinear: none inside, 1 at the cut. 4 nearest texels: half a jump twice a texel, at the "
               "cut as inside. Photon map: no error under linear light.",
     .advice = "Look up the nearest texels in space, the default, where charts meet on smooth surfaces. "
               "Bilinear is smoother inside a chart; use it with few cuts, and those at corners.",
     .mutations = {"the photon map has charts", "the nearest texels are looked up in the lightmap"},
     .run = run});

}  // namespace
}  // namespace bench::stability
