// 10. Accumulation: a photon map also sums, over all photons of a gather.
#include "bench/experiments/stability/float_sums.h"
#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {
namespace {

using common::Rgb;
using photonmap::GatherSettings;

constexpr float watts = 0.7f;  // of each photon: roulette gives most photons of a scene the same
constexpr float radius = 2;    // holds all photons

common::HitBatch equal_photons(double count) {
    Generator generator(1);
    common::HitBatch hits;
    irradiate_quad(hits, unit_floor(), 0, static_cast<std::size_t>(count), generator, always({0, 0, -1}));
    for (Rgb& flux : hits.flux) flux = {watts, watts, watts};
    return hits;
}

/// Returns the sum of a gather in the middle, which it divides by the area of its disc, relative to `photons`
/// times their flux.
template <class Map>
double sum_of_gather(const Map& map, double photons) {
    const auto middle = on_unit_floor(0.5f, 0.5f);
    const double area = scene_builder::pi * radius * radius;
    return map.irradiance(middle).x * area / (photons * double{watts});
}

/// Sums one after the other in a float.
double sum_of_floats(const common::HitBatch& hits) {
    float sum = 0;
    for (const Rgb& flux : hits.flux) sum += flux.x;
    return sum / (static_cast<double>(hits.size()) * double{watts});
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const std::vector<double> places =
        run.either<std::vector<double>>({1e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6}, {1e3, 1e4, 3e4, 1e5, 2e5});
    const auto one = [](double) { return 1.0; };
    const bool exact = run.has_mutation("floats never round");
    // The answer is a float; the radius comes from two others and is squared.
    constexpr double float_answer = 8 * 0x1p-24;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, all within the radius", places, one, Expected::equal, float_answer),
        // Groups of 64 are summed as floats, each rounded by half a unit of the sum so far.
        curve_at("photon map, one more than there are nearest", places, one, Expected::equal,
                 float_answer + 64 * 0x1p-25),
        curve_at(
            "one float", places,
            [&](double n) { return exact ? 1 : float_sum_of_equal_adds(watts, n) / (n * double{watts}); },
            Expected::equal, allowed_of_float_sum)};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const common::HitBatch hits = equal_photons(places[i]);
        const common::Scene& scene = unit_floor();
        const auto all = photon_map_of(scene, hits, within(scene, radius));
        const auto nearest_of_all = all.with_gather(nearest(hits.size() + 1, radius));
        const bool floats = run.has_mutation("the gather sums floats");
        curves[0].points[i].measured = {floats ? sum_of_floats(hits) : sum_of_gather(all, places[i])};
        curves[1].points[i].measured = {sum_of_gather(nearest_of_all, places[i])};
        curves[2].points[i].measured = {sum_of_floats(hits)};
    }
    return curves;
}

const RegisteredCase registered(
    102,
    {.name = "gather-sums",
     .purpose = "Sums of many photons in one gather: a float is 0.2 % off after 2e5 photons of 0.7 W, and 1 "
                "% after 1e6, ten times the noise that so many leave.",
     .scene = "Photons of 0.7 W, head on, all of them within one gather. Nothing depends on a seed.",
     .swept = "photons in the gather: N",
     .measured = "sum / exact sum",
     .theory = "1 in doubles. In a float each add is rounded to whole steps of the sum, the same way each "
               "time while the sum is between two powers of two: up to N / 2^24 off.",
     .advice = "No remedy needed: gathers sum doubles.",
     .mutations = {"floats never round", "the gather sums floats"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
