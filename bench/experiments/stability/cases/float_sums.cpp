// 10. Accumulation: a float sum of equal values is wrong long before it stops at 2^24 of them.
#include "bench/experiments/stability/float_sums.h"

#include "bench/contenders/plain_sums.h"
#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using Floats = PlainSums<FlatModel, float>;
using Doubles = PlainSums<FlatModel, double>;
using Ours = shlm::TexelSums<FlatModel>;

const shlm::Quantum white({1, 1, 1});

/// Returns number k of the only texel.
template <class Number>
double value(const PlainSums<FlatModel, Number>& sums, std::size_t k) {
    return sums.value(0, k);
}
double value(const Ours& sums, std::size_t k) {
    return sums[0].value[k];
}

/// Calls `measure(i, sums)` for each number of hits, in ascending order, with the sums of so many hits.
/// `flux()` is that of each hit.
template <class Sums, class Flux, class Measure>
void add_hits(std::span<const double> numbers_of_hits, Flux flux, Measure measure) {
    Sums sums(1, white);
    std::uint64_t added = 0;
    for (std::size_t i = 0; i < numbers_of_hits.size(); ++i) {
        for (; added < static_cast<std::uint64_t>(numbers_of_hits[i]); ++added)
            sums.add(0, {0, 0, 1}, 1, flux());
        measure(i, sums);
    }
}

/// Red sums 1, green sums 0.7.
constexpr float green = 0.7f;
common::Rgb equal() {
    return {1, green, 1};
}

template <class Sums>
void measure_equal_adds(std::span<const double> places, StabilityCurve* red_curve,
                        StabilityCurve& green_curve) {
    add_hits<Sums>(places, equal, [&](std::size_t i, const Sums& sums) {
        if (red_curve) red_curve->points[i].measured = {value(sums, 0) / places[i]};
        green_curve.points[i].measured = {value(sums, 1) / (places[i] * double{green})};
    });
}

/// Returns the flux rounded to quanta; if the light has 1 W, that is 2^23 quanta.
double in_quanta(double watts) {
    return std::rint(watts * 0x1p23) * 0x1p-23;
}

/// Adds multiples of 2^-24 below 1, which doubles sum without error up to 2^29.
template <class Sums>
void measure_random_adds(std::span<const double> places, StabilityCurve& curve) {
    Generator generator(1);
    double exact = 0;
    const auto flux = [&] {
        const float watts = uniform(generator);
        exact += watts;
        return common::Rgb(watts, watts, watts);
    };
    add_hits<Sums>(places, flux, [&](std::size_t i, const Sums& sums) {
        curve.points[i].measured = {value(sums, 0) / exact};
    });
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const std::vector<double> places = run.either<std::vector<double>>(
        {1e4, 1e5, 1e6, 3e6, 1e7, 2e7, 4e7, 1e8, 3e8, 1e9}, {1e4, 1e5, 1e6, 3e6, 1e7, 2e7, 4e7});
    const double stops = run.has_mutation("floats have 25 bits") ? 0x1p25 : 0x1p24;
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("float, 1 W each", places, [&](double n) { return std::min(1.0, stops / n); }),
        curve_at(
            "float, 0.7 W each", places,
            [](double n) { return float_sum_of_equal_adds(green, n) / (n * double{green}); }, Expected::equal,
            allowed_of_float_sum),
        // Below 1 W, no add changes a float at 2^24, where the step is 2 W.
        curve_at("float, 0 to 1 W each", places, [&](double n) { return std::min(1.0, stops / (n / 2)); }),
        curve_at("double, 0.7 W each", places, one),
        curve_at(
            "light map, 0.7 W each", places, [](double) { return in_quanta(green) / green; }, Expected::equal,
            0x1p-50),
        curve_at("light map, 0 to 1 W each", places, one)};
    for (std::size_t i = 0; i < places.size(); ++i) {
        // Five standard deviations for chance. Below the limit it is that of roundings to a step, 2^-23 of
        // the sum. Above it, it is that of the exact sum, as a uniform number has the deviation 1 / sqrt(12).
        curves[2].points[i].allowed =
            5 * (places[i] / 2 < stops ? std::sqrt(places[i] / 12) * 0x1p-23 : 1 / std::sqrt(3 * places[i]));
        curves[3].points[i].allowed = places[i] * 0x1p-53;
        curves[5].points[i].allowed = 2 * 0x1p-24;  // half a quantum per hit, which has half a watt
    }
    measure_equal_adds<Floats>(places, &curves[0], curves[1]);
    measure_random_adds<Floats>(places, curves[2]);
    measure_equal_adds<Doubles>(places, nullptr, curves[3]);
    if (run.has_mutation("the light map sums floats")) {
        measure_equal_adds<Floats>(places, nullptr, curves[4]);
        measure_random_adds<Floats>(places, curves[5]);
    } else {
        measure_equal_adds<Ours>(places, nullptr, curves[4]);
        measure_random_adds<Ours>(places, curves[5]);
    }
    return curves;
}

const RegisteredCase registered(
    100,
    {.name = "float-sums",
     .purpose = "Sums of many hits on one texel: floats stop at 2^24 equal ones, which a bright texel has "
                "after minutes, and are off by percents long before.",
     .scene = "One texel that takes hits of 1 W, of 0.7 W, or of anything from 0 to 1 W, one after the "
              "other. Nothing depends on a seed.",
     .swept = "hits on the texel: N",
     .measured = "sum / exact sum",
     .theory = "Float: min(1, 2^24 / N) for 1 W; for 0.7 W each add is rounded to whole steps of the sum; "
               "min(1, 2^25 / N) for random ones. Double: 1. Light map: 1, but for "
               "the rounding of each add to a quantum, 2^-23 W.",
     .advice = "No remedy needed in the light map: its sums are integers, 32 bits drained into 64.",
     .mutations = {"floats have 25 bits", "the light map sums floats"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
