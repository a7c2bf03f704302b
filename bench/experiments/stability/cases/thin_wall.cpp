// 3. Light leaks under a thin wall, which a disc of photons does not see.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

constexpr double width = 2, radius = 0.1;
constexpr std::size_t nearest_photons = 50;
constexpr std::size_t texels_along = 40;
constexpr double texel = width / texels_along;

const common::Scene& one_floor() {
    static const common::Scene made = square_floor(width);
    return made;
}

/// Returns the radius of the disc whose lit part, beyond a straight line at `distance`, is the fraction
/// `part` of the floor.
double radius_that_holds(double part, double distance) {
    double low = distance, high = width;
    for (int step = 0; step < 50; ++step) {
        const double r = 0.5 * (low + high);
        (std::numbers::pi * r * r * segment_of_disc(distance / r) < part * width * width ? low : high) = r;
    }
    return high;
}

/// Returns the mean estimate of the k nearest, for N photons that are sent to the whole floor, of which those
/// beyond the wall do not arrive. Let u be the fraction of the floor that is lit and nearer than the k-th. It
/// is a k-th order statistic, distributed as Beta(k, N - k + 1). With R for u by radius_that_holds, the k - 1
/// photons inside read (k - 1) / N times floor / (pi R^2), which is (k - 1) / (N u) times the lit part of the
/// disc.
double read_by_nearest(double distance, std::size_t photons) {
    const auto k = static_cast<double>(nearest_photons), n = static_cast<double>(photons);
    double sum = 0, weights = 0;
    for (int step = -60; step <= 100; ++step) {  // tenths of a standard deviation
        const double u = (k + 0.1 * step * std::sqrt(k)) / n;
        const double weight = std::exp((k - 1) * std::log(u * n / k) + (n - k) * std::log1p(-u));
        sum += weight * (k - 1) / (n * u) * segment_of_disc(distance / radius_that_holds(u, distance));
        weights += weight;
    }
    return sum / weights;
}

/// Returns the estimate of the four nearest texels at the points; texels with centres at x < 0 are lit.
double read_by_texels(const std::vector<common::SurfacePoint>& points) {
    const auto lit = [](double column, double) { return column < 0 ? 1.0 : 0.0; };
    double sum = 0;
    for (const common::SurfacePoint& point : points)
        sum += mean_of_four_nearest(point.position.x / texel - 0.5, point.position.y / texel - 0.5, lit);
    return sum / static_cast<double>(points.size());
}

std::vector<common::SurfacePoint> points_at(double distance) {
    return points_across(one_floor(), 0, 0.5 + distance / width);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const common::Scene& scene = one_floor();
    const auto photons = run.either<std::size_t>(2'000'000, 200'000);
    const double farthest = photonmap::default_max_radius(scene.diagonal());
    constexpr double places[] = {0.01, 0.02, 0.03, 0.045, 0.08, 0.12, 0.2, 0.35, 0.5};
    const auto by_nearest = [&](double distance) { return read_by_nearest(distance, photons); };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, r = 0.1", places, [](double d) { return segment_of_disc(d / radius); }),
        curve_at("photon map, 50 nearest, no maximum radius", places, by_nearest),
        // At 0.12 the maximum radius still holds 108 photons or more on average, so there are practically
        // always 50.
        curve_at("photon map, 50 nearest, maximum radius 0.14", places,
                 [&](double d) { return d < farthest ? by_nearest(d) : 0; }),
        curve_at("light map, own texel", places, [](double) { return 0.0; }),
        curve_at("light map, 4 nearest texels", places,
                 [](double d) { return read_by_texels(points_at(d)); })};
    const shlm::PreparedTexels prepared = texels_of(scene, texels_along * texels_along);
    const double capped = run.has_mutation("the largest radius is as wide as the floor") ? width : farthest;
    const std::size_t texels = run.has_mutation("16 nearest texels") ? 16 : 4;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        common::HitBatch all;
        irradiate_quad(all, scene, 0, photons, generator, always({0, 0, -1}));
        const common::HitBatch hits = lit_where(all, [](const common::Vec3& at) { return at.x < 0; });
        const auto photon_map = photon_map_of(scene, hits, within(scene, radius));
        const auto endless = photon_map.with_gather(nearest(nearest_photons, width));
        const auto ending = photon_map.with_gather(nearest(nearest_photons, capped));
        const auto own = light_map_of<FlatModel>(prepared, hits, shlm::OwnTexel{});
        const auto near_texels = light_map_of<FlatModel>(prepared, hits, shlm::NearestTexels{texels});
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const auto points = points_at(places[i]);
            curves[0].points[i].measured.push_back(mean_irradiance(photon_map, points));
            curves[1].points[i].measured.push_back(mean_irradiance(endless, points));
            curves[2].points[i].measured.push_back(mean_irradiance(ending, points));
            curves[3].points[i].measured.push_back(mean_irradiance(own, points));
            curves[4].points[i].measured.push_back(mean_irradiance(near_texels, points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    30,
    {.name = "thin-wall",
     .purpose = "Light leaks under a thin wall that stands on a floor of two rooms: photons of the lit "
                "room count in the dark one. The normal test cannot help.",
     .scene = "A floor of 2 x 2, irradiated with 1 W/m^2 where x < 0, 500,000 photons a square metre (short "
              "form: 50,000); a wall and the dark beyond it. Its texels are 0.05 wide and end at the "
              "wall. Means over 64 points along it. What is 0 is beyond the chart's lower end.",
     .swept = "thickness of the wall + depth in the dark room",
     .measured = "irradiance / that of the lit room",
     .theory = "Radius r: s(d / r), s(t) = (acos t - t sqrt(1 - t^2)) / pi, the disc's part on the lit "
               "side. k nearest: the same with the radius that holds k, averaged over how it varies; it "
               "never ends, or at the maximum radius. Light map: no farther than a texel.",
     .advice = "A maximum radius, always on, ends the leak; walls should be thicker than that, or rooms "
               "have floors of their own. A light map's texels should end at walls.",
     .mutations = {"the largest radius is as wide as the floor", "16 nearest texels"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
