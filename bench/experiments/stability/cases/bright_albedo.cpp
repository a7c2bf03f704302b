// 17. Bright walls: light that is reflected many times.
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

/// Returns the expected arrivals of a photon that each wall reflects with probability `albedo`: 1 + albedo +
/// albedo^2 and so on, up to the tracer's limit.
double arrivals(double albedo) {
    return (1 - std::pow(albedo, common::max_events)) / (1 - albedo);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const std::vector<float> albedos = run.full() ? std::vector<float>{0, 0.5f, 0.9f, 0.99f, 0.999f}
                                                  : std::vector<float>{0, 0.5f, 0.9f, 0.98f};
    std::vector<double> places;
    for (const float albedo : albedos) places.push_back(arrivals(albedo));
    const bool reflected = run.has_mutation("the photon map stores what is reflected");
    const bool by_flux = run.has_mutation("the light map has the flux weight");
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {curve_at("photon map", places, one),
                                          curve_at("light map", places, one)};
    // At each arrival, roulette rounds a photon's flux twice. At most 5.2 x 2^-23 of the photons slip through
    // where walls meet (see far-from-origin). The sums and texels round by 2^-22.
    for (StabilityCurve& curve : curves)
        for (StabilityPoint& point : curve.points) point.allowed = 0x1p-22 + point.at * 7 * 0x1p-23;
    const shlm::PreparedTexels texels = texels_of(lit_box(0), 600);

    run.for_each_seed([&](std::uint64_t seed) {
        for (std::size_t i = 0; i < albedos.size(); ++i) {
            // About as many hits at each albedo, but at least one block of photons.
            const double hits = run.either(5e5, 5e4);
            const auto blocks = static_cast<std::uint64_t>(hits / places[i] / common::photons_per_block) + 1;
            const TracedHits run_of =
                traced(lit_box(albedos[i]), seed, {.photons = blocks * common::photons_per_block});
            const double expected =
                4 * scene_builder::pi * places[i] / static_cast<double>(run_of.report.watts_per_flux());
            const double kept = reflected ? albedos[i] : 1;
            curves[0].points[i].measured.push_back(light_in_photons(run_of.hits) * kept / expected);
            curves[1].points[i].measured.push_back(
                (by_flux ? light_in_texels<shlm::ShWeight::flux>(texels, run_of.hits)
                         : light_in_texels(texels, run_of.hits)) /
                expected);
        }
    });
    return curves;
}

const RegisteredCase registered(
    170, {.name = "bright-albedo",
          .purpose = "In bright rooms light goes on for hundreds of reflections, of which each must keep the "
                     "balance.",
          .scene = "A closed box of walls with albedo 0, 0.5, 0.9, 0.99 (full form: 0.999) and a point light "
                   "inside. Seeds draw all photons.",
          .swept = "arrivals of a photon, 1 / (1 - albedo) but for the limit",
          .measured = "stored light / predicted",
          .theory =
              "Power (1 - albedo^4096) / (1 - albedo): photons are given up after 4096 arrivals, which takes "
              "1.7 % at an albedo of 0.999 and less than 10^-17 up to 0.99.",
          .advice = "Nothing to do up to an albedo of 0.99. White walls: see white-room.",
          .mutations = {"the photon map stores what is reflected", "the light map has the flux weight"},
          .run = run,
          .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
