// 4. Proximity bias: under a near light, the mean over a disc or texel differs from the value in its middle.
#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::HitBatch;
using common::Vec3;

constexpr double texels_along = 3;  ///< an odd number: one is right below the light
constexpr double pi = std::numbers::pi;

/// Makes photons of a point light at height 1 above the middle of the floor, with 1 W/m^2 right below it, in
/// the first channel. The second channel has the same photons for 1 W/m^2 everywhere. The difference is bias,
/// almost without the noise that both have in common.
HitBatch photons_of_lamp(const common::Scene& floor, std::size_t count, Generator& generator) {
    HitBatch hits;
    irradiate_quad(hits, floor, 0, count, generator, always({0, 0, -1}));
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Vec3 from_lamp = hits.position[i] - Vec3(0, 0, 1);
        const float distance = from_lamp.length(), flux = hits.flux[i].x;
        hits.direction[i] = from_lamp / distance;
        hits.flux[i] = {flux / (distance * distance * distance), flux, 0};
    }
    return hits;
}

// Losses right below the light, relative to 1 / H^2, with H = 1.

/// The disc is the base of a cone of solid angle 2 pi (1 - 1 / sqrt(1 + r^2)), which is the flux on it.
double loss_of_disc(double r) {
    return 1 - 2 / (r * r) * (1 - 1 / std::sqrt(1 + r * r));
}

/// The square is the base of a pyramid of solid angle 4 asin(a^2 / (a^2 + 1)), where a = h / 2.
double loss_of_square(double h) {
    const double a_sq = h * h / 4;
    return 1 - 4 * std::asin(a_sq / (a_sq + 1)) / (h * h);
}

template <class Map>
double loss_read_by(const Map& map, const common::Scene& floor, double width) {
    const common::Rgb read = map.irradiance(floor_point(floor, width, 0, 0));
    return double{read.y} - double{read.x};
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double sizes[] = {0.0625, 0.125, 0.25, 0.5, 1};
    const bool round = run.has_mutation("a texel is a disc");
    const double gathered = run.has_mutation("the radius is a tenth larger") ? 1.1 : 1;
    constexpr double rounding = 1e-5;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, radius r", sizes, loss_of_disc, Expected::equal, rounding),
        curve_at(
            "light map, own texel of width h", sizes,
            [&](double h) { return round ? loss_of_disc(h / 2) : loss_of_square(h); }, Expected::equal,
            rounding)};
    std::vector<common::Scene> floors;
    std::vector<shlm::PreparedTexels> prepared;
    for (const double h : sizes) {
        floors.push_back(square_floor(texels_along * h));
        prepared.push_back(texels_of(floors.back(), static_cast<std::size_t>(texels_along * texels_along)));
    }

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(sizes); ++i) {
            const common::Scene& floor = floors[i];
            const double width = texels_along * sizes[i];
            const HitBatch hits = photons_of_lamp(floor, run.either<std::size_t>(500'000, 20'000), generator);
            const auto photon_map = photon_map_of(floor, hits, within(floor, gathered * sizes[i]));
            const auto light_map = light_map_of<FlatModel>(prepared[i], hits, shlm::OwnTexel{});
            curves[0].points[i].measured.push_back(loss_read_by(photon_map, floor, width));
            curves[1].points[i].measured.push_back(loss_read_by(light_map, floor, width));
        }
    });
    return curves;
}

const RegisteredCase registered(
    40,
    {.name = "steep-gradient",
     .purpose = "Proximity bias: where light changes within the gather's disc or the texel, their mean is "
                "not the value in the middle. More photons do not help.",
     .scene = "A floor under a point light of height H, asked right below it. The same photons under even "
              "light, in another channel, say what part of what is read is noise.",
     .swept = "r / H, h / H",
     .measured = "loss of irradiance / truth",
     .theory = "Disc: 1 - 2 H^2 / r^2 (1 - 1 / sqrt(1 + r^2 / H^2)), 3/4 r^2 / H^2 where r is small. "
               "Texel: 1 - Omega H^2 / h^2, Omega = 4 asin(h^2 / (h^2 + 4 H^2)) the square's solid angle, "
               "1/4 h^2 / H^2 where h is small. Slope 2 for both; equal for pi r^2 = 1.05 h^2.",
     .advice = "Smaller texels or radii, a quarter of the bias for half the size. With equal areas both "
               "methods lose the same.",
     .mutations = {"a texel is a disc", "the radius is a tenth larger"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
