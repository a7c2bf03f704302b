// 5. Blur: how much remains of the peak of a small spot of light, such as a caustic's focus.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/panels.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/theory.h"

namespace bench::stability {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double max_radius = 5;

/// Makes photons of a disc of light of radius 1 and 1 W/m^2 in the middle of the floor.
common::HitBatch spot_on(double width, const common::Scene& floor, std::size_t count, Generator& generator) {
    const auto flux = static_cast<float>(pi / static_cast<double>(count));
    common::HitBatch hits;
    hits.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float u1 = uniform(generator), u2 = uniform(generator);
        const common::Vec2 at = common::sample_disc(u1, u2);
        const common::SurfaceId on = on_floor(width, at.x, at.y);
        hits.push_back(common::position_at(floor, on), {0, 0, -1}, {flux, flux, flux}, on);
    }
    return hits;
}

// Predictions for the middle of the spot; lengths are in units of its radius.

double read_by_disc(double r) {
    return std::min(1.0, 1 / (r * r));
}

/// Returns the lit fraction of a texel of width h that is centred on the spot. If the spot reaches over the
/// texel's sides but not its corners, four segments of it are outside.
double read_by_texel(double h) {
    if (h <= std::numbers::sqrt2) return 1;
    return pi / (h * h) * (1 - 4 * segment_of_disc(h / 2));
}

/// As long as photons are as dense everywhere as in the spot, photons times r^2 is the k of a gather of
/// radius r. The k - 1 that are nearer than the k-th then read exactly 1 on average. If the spot has fewer
/// than k photons, all of them are divided by the area of the largest disc.
double read_by_nearest(double r) {
    return r < 1 ? 1 : 1 / (max_radius * max_radius);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double sizes[] = {0.4, 0.6, 0.8, 0.95, 1.2, 1.6, 2.4, 4};
    const auto photons = run.either<std::size_t>(40'000, 10'000);
    constexpr double rounding = 1e-5;
    // The k nearest are summed as floats: equal values may each round by half a unit of the last place.
    const double rounding_of_sum = rounding + static_cast<double>(photons) * 0x1p-25;
    const auto whole = [](double) { return 1.0; };
    const bool unspoilt = run.has_mutation("a texel keeps the peak");
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, radius r", sizes, read_by_disc, Expected::equal, rounding),
        curve_at("photon map, k nearest, maximum radius 5 s", sizes, read_by_nearest, Expected::equal,
                 rounding_of_sum),
        curve_at(
            "light map, own texel of width h", sizes,
            [&](double size) { return unspoilt ? whole(size) : read_by_texel(2 * size); }, Expected::equal,
            rounding)};
    std::vector<common::Scene> floors;
    std::vector<shlm::PreparedTexels> prepared;
    for (const double size : sizes) {
        floors.push_back(square_floor(3 * 2 * size));
        prepared.push_back(texels_of(floors.back(), 9));
    }
    const double gathered = run.has_mutation("the radius is a tenth larger") ? 1.1 : 1;

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(sizes); ++i) {
            const double size = sizes[i], width = 3 * 2 * size;
            const common::HitBatch hits = spot_on(width, floors[i], photons, generator);
            const auto k = static_cast<std::size_t>(std::llround(size * size * static_cast<double>(photons)));
            const auto photon_map = photon_map_of(floors[i], hits, within(floors[i], gathered * size));
            const auto by_number = photon_map.with_gather(nearest(k, max_radius));
            const auto light_map = light_map_of<FlatModel>(prepared[i], hits, shlm::OwnTexel{});
            const common::SurfacePoint middle = floor_point(floors[i], width, 0, 0);
            const auto read = [&](const auto& map) {
                return double{common::mean_component(map.irradiance(middle))};
            };
            curves[0].points[i].measured.push_back(read(photon_map));
            curves[1].points[i].measured.push_back(read(by_number));
            curves[2].points[i].measured.push_back(read(light_map));
        }
    });
    return curves;
}

/// Draws truth, photon map, own texel and bilinear side by side, with gathers of equal area.
std::optional<common::Image> picture() {
    constexpr double width = 4;
    constexpr std::size_t texels_along = 9;
    const common::Scene floor = square_floor(width);
    const shlm::PreparedTexels prepared = texels_of(floor, texels_along * texels_along);
    Generator generator(1);
    const common::HitBatch hits = spot_on(width, floor, 100'000, generator);
    const auto photon_map = photon_map_of(floor, hits, within(floor, width / texels_along / std::sqrt(pi)));
    const auto own = light_map_of<FlatModel>(prepared, hits, shlm::OwnTexel{});
    const auto bilinear = light_map_of<FlatModel>(prepared, hits, shlm::Bilinear{});

    return panels_side_by_side<4>([&](double right, double down) -> std::array<common::Rgb, 4> {
        const double x = (right - 0.5) * width, y = (0.5 - down) * width;
        const common::SurfacePoint point = floor_point(floor, width, x, y);
        const common::Rgb truth(x * x + y * y < 1 ? 1.0f : 0.0f);
        return {truth, photon_map.irradiance(point), own.irradiance(point), bilinear.irradiance(point)};
    });
}

const RegisteredCase registered(
    51,
    {.name = "bright-spot",
     .purpose = "Blur: a small bright spot, such as a caustic's focus, loses its peak to what is gathered "
                "around it. More photons do not help.",
     .scene = "A disc of light of radius s and 1 W/m^2 on a floor, asked in its middle, which is the "
              "middle of a texel too. Pictures: truth, photon map, own texel and bilinear, s = 2.25 h, "
              "pi r^2 = h^2.",
     .swept = "r / s, h / 2 s; k nearest: root of k / photons in the spot",
     .measured = "irradiance / truth",
     .theory = "Disc: s^2 / r^2 beyond r = s. Texel: pi s^2 / h^2 where the spot is inside, less the four "
               "segments that reach over its sides; 1 where it covers the texel. k nearest: 1 to where "
               "the spot has fewer than k photons; then they are divided by the largest disc.",
     .advice = "A map of its own for caustics, with texels or radii smaller than their detail. k nearest "
               "keeps a peak as long as it has k photons of its own.",
     .mutations = {"the radius is a tenth larger", "a texel keeps the peak"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true,
     .picture = picture});

}  // namespace
}  // namespace bench::stability
