// 11. Grazing light: the effect of the weight 1 / cos on the noise.
#include <numbers>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {
namespace {

using common::HitBatch;

constexpr double pi = std::numbers::pi, tilt = pi / 3;
constexpr double clamps[] = {1, 1e-1, 1e-2, 1e-3}, low_clamps[] = {1e-3, 1e-4, 1e-5};
constexpr double ours[] = {common::min_incident_cosine};
constexpr std::size_t side = 32;  // texels, and discs
constexpr double disc_radius = 0.015;

/// Draws directions like diffusely_onto, but with cosines down to 1e-8.
common::Vec3 from_uniform_sky(Generator& generator) {
    const double u = static_cast<double>(generator() >> 11) * 0x1p-53;
    return -common::direction_at(static_cast<float>(std::sqrt(1 - u)), uniform(generator));
}

/// Returns the second moment over the squared mean of a photon's weight in uniform light, 2 c dc at cosine c.
double order_0_noise(double e) {
    return (1 + 2 * std::log(1 / e)) / ((2 - e) * (2 - e));  // of 1 / max(c, e)
}

/// Returns the same for k2(c) / max(c, e), whose mean is 1 within e / 10. Above e, 2 k2^2 / c dc is
/// integrated term by term; below it, k2(0)^2 is used.
double order_2_noise(double e) {
    const double terms = 9 * std::log(1 / e) + 96 * (1 - e) + 346 * (1 - e * e) / 2 +
                         480 * (1 - e * e * e) / 3 + 225 * (1 - e * e * e * e) / 4;
    return (2 * terms + 9) / (32 * 32);
}

/// Returns the same for the cosine to a plane tilted by a, over max(c, e), by quadrature over v = c^(1/4) and
/// the azimuth.
double tilted_noise(double a, double e) {
    constexpr int steps = 1000;
    double mean = 0, square = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps / 4; ++j) {
            const double v = (i + 0.5) / steps, c = v * v * v * v, azimuth = (j + 0.5) / (steps / 4) * pi;
            const double cosine =
                std::max(0.0, c * std::cos(a) + std::sqrt(1 - c * c) * std::sin(a) * std::cos(azimuth));
            const double weight = cosine / std::max(c, e), share = 8 * std::pow(v, 7) / steps / (steps / 4);
            mean += share * weight;
            square += share * weight * weight;
        }
    return square / (mean * mean);
}

/// Returns the variance of the readings over their squared mean, times the photons per place. For independent
/// photons this is the second moment of their weights over the squared mean: 1 for equal weights.
double noise_of(const std::vector<double>& readings, double photons_each) {
    const auto count = static_cast<double>(readings.size());
    double mean = 0, squares = 0;
    for (const double reading : readings) mean += reading / count;
    for (const double reading : readings) squares += (reading - mean) * (reading - mean);
    return squares / (count - 1) / (mean * mean) * photons_each;
}

/// Returns the noise of texels, each read at its own normal.
template <class Model>
double texel_noise(const HitBatch& hits) {
    static const shlm::PreparedTexels texels = texels_of(unit_floor(), side * side);
    const auto map = light_map_of<Model>(texels, hits, shlm::OwnTexel{});
    std::vector<double> readings;
    for (const auto& texel : map.texels()) readings.push_back(texel.irradiance(texel.face.normal).x);
    return noise_of(readings, static_cast<double>(hits.size()) / static_cast<double>(readings.size()));
}

/// Returns the same from this case's own sums, for any clamp and order 0.
double own_noise(const HitBatch& hits, double clamp) {
    std::vector<double> sums(side * side);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        // A coordinate just below 1 may have been rounded up to 1.
        const auto texel_along = [](float x) {
            return std::min(static_cast<std::size_t>(x * side), side - 1);
        };
        const std::size_t column = texel_along(hits.position[i].x), row = texel_along(hits.position[i].y);
        sums[row * side + column] += 1 / std::max<double>(-hits.direction[i].z, clamp);
    }
    return noise_of(sums, static_cast<double>(hits.size()) / (side * side));
}

/// Returns the noise of discs that do not touch, centred on the texels.
template <class Map>
double disc_noise(const Map& map, double disc_area, double angle) {
    std::vector<double> readings;
    for (std::size_t i = 0; i < side * side; ++i) {
        const common::SurfacePoint middle = on_unit_floor((static_cast<float>(i % side) + 0.5f) / side,
                                                          (static_cast<float>(i / side) + 0.5f) / side);
        readings.push_back(map.irradiance(scene_builder::tilted(middle, angle, 0)).x);
    }
    return noise_of(readings, static_cast<double>(map.size()) * disc_area);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    using Radiance0 = HarmonicModel<0>;
    using Radiance2 = HarmonicModel<2>;
    using Normalised2 = shlm::TexelModel<2, shlm::ShWeight::normalised>;
    const double disc_area = disc_radius * disc_radius * (run.has_mutation("discs are squares") ? 4 : pi);
    const bool not_normalised = run.has_mutation("the weight is not normalised");
    const double wrong = run.has_mutation("the logarithm counts once") ? 0.5 : 1;
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("order 0, sums of this case's own", clamps,
                 [&](double e) { return order_0_noise(std::pow(e, wrong)); }),
        // The largest weights dominate but are rare: the estimate is too small, or far too large with one of
        // them.
        curve_at("order 0, lower clamps", low_clamps, order_0_noise, Expected::shown),
        curve_at("light map, order 0", ours, order_0_noise),
        // The mean is 1 - 3 e / 32, and below e, k2^2 is a little more than 9 / 1024.
        curve_at("light map, order 2", ours, order_2_noise, Expected::equal, ours[0]),
        curve_at("light map, order 2, normalised", ours, one),
        // Below e, a photon counts c / e; this changes the result by one part in a million.
        curve_at("photon map", ours, one, Expected::equal, 1e-6),
        // Midpoints of 1000 and 250 steps: half as many change the result by less than this.
        curve_at(
            "photon map, tilted by 60 degrees", ours, [](double e) { return tilted_noise(tilt, e); },
            Expected::equal, 1e-4)};

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        HitBatch hits;
        irradiate_quad(hits, unit_floor(), 0, run.either<std::size_t>(2'000'000, 200'000), generator,
                       from_uniform_sky);
        for (std::size_t i = 0; i < std::size(clamps); ++i)
            curves[0].points[i].measured.push_back(own_noise(hits, clamps[i]));
        for (std::size_t i = 0; i < std::size(low_clamps); ++i)
            curves[1].points[i].measured.push_back(own_noise(hits, low_clamps[i]));
        const auto photon_map =
            map_of(photonmap::GridPhotonSink(unit_floor(), within(unit_floor(), disc_radius)), hits);
        curves[2].points[0].measured.push_back(texel_noise<Radiance0>(hits));
        curves[3].points[0].measured.push_back(texel_noise<Radiance2>(hits));
        curves[4].points[0].measured.push_back(not_normalised ? texel_noise<Radiance0>(hits)
                                                              : texel_noise<Normalised2>(hits));
        curves[5].points[0].measured.push_back(disc_noise(photon_map, disc_area, 0));
        curves[6].points[0].measured.push_back(disc_noise(photon_map, disc_area, tilt));
    });
    return curves;
}

const RegisteredCase registered(
    112,
    {.name = "grazing-noise",
     .purpose = "The weight 1 / cos of grazing hits has no finite variance under uniform light: a few hits "
                "outweigh all others, and more of them do not help as they should.",
     .scene = "A floor of 1 x 1 under a uniform sky, 1024 texels, and as many discs of radius 0.015 in a "
              "photon map. Seeds draw all photons.",
     .swept = "clamp e of the cosine (the maps' own is 0.001)",
     .measured = "variance x photons / mean^2",
     .theory = "A photon's weight w makes it E[w^2] / E[w]^2, 1 where all count the same. Order 0: (1 + 2 "
               "ln(1 / e)) / (2 - e)^2. Order 2 at the surface's own normal keeps (3 / 32)^2 of that "
               "logarithm: 1.08. Normalised and photon map: 1; a photon map asked for a tilted normal "
               "divides too: quadrature.",
     .advice =
         "Order 2 hardly has the problem at the surface's own normal, the normalised weight not at all. "
         "Order 0 alone needs 3.7 times the hits, a photon map at a normal tilted by 60 degrees 5.6 times.",
     .mutations = {"the logarithm counts once", "the weight is not normalised", "discs are squares"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
