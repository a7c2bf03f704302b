// 17. Very dim and very bright scenes.
#include "bench/experiments/stability/same_answers.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

/// Exponents of two for the intensity: floats scale by powers of two without rounding.
constexpr int judged[] = {-96, -60, -20, 0, 20, 60, 100}, beyond[] = {-126, -120, -110, -100, 110, 120};

std::vector<double> powers_of_two(std::span<const int> exponents) {
    std::vector<double> powers;
    for (const int exponent : exponents) powers.push_back(std::ldexp(1.0, exponent));
    return powers;
}

BoxAnswers answers_with_power(float power, const CaseRun& run, std::uint64_t seed) {
    static const shlm::PreparedTexels texels = texels_of(lit_box(0.5f), 600);
    common::Scene scene = lit_box(0.5f);
    scene.point_light[0].intensity *= power;
    const auto [hits, report] =
        traced(scene, seed, {.photons = common::photons_per_block * run.either<std::uint64_t>(8, 1)});
    return answers_in_box(scene, texels, hits, 0.4, 1 / power, Generator(seed));
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const float wrong = run.has_mutation("power is no power of two") ? 1.1f : 1;
    std::vector<StabilityCurve> curves = curves_of_differences(powers_of_two(judged), "", Expected::equal);
    const auto shown = curves_of_differences(powers_of_two(beyond), ", beyond", Expected::shown);
    curves.insert(curves.end(), shown.begin(), shown.end());
    run.for_each_seed([&](std::uint64_t seed) {
        const BoxAnswers at_1 = answers_with_power(1, run, seed);
        for (std::size_t i = 0; i < std::size(judged); ++i)
            measure_differences(std::span(curves).first(4), i,
                                answers_with_power(wrong * std::ldexp(1.0f, judged[i]), run, seed), at_1);
        for (std::size_t i = 0; i < std::size(beyond); ++i)
            measure_differences(std::span(curves).last(4), i,
                                answers_with_power(std::ldexp(1.0f, beyond[i]), run, seed), at_1);
    });
    return curves;
}

const RegisteredCase registered(
    173,
    {.name = "dim-light",
     .purpose =
         "Thresholds that are meant for ordinary scenes make dim ones black or coarse, and bright ones "
         "overflow.",
     .scene =
         "A closed box of albedo 0.5 with a point light whose intensity is swept in powers of two; 96 places "
         "on the walls. Seeds draw all photons.",
     .swept = "intensity of the light, W/sr",
     .measured = "part of the answers / intensity that differ from those at 1 W/sr",
     .theory =
         "None, to the bit: nothing is compared with a light of fixed size, photons follow the same paths, "
         "floats and the light map's quanta scale with the light. Quanta are 2^-120 at the least, for "
         "lights of 2^-97 W; floats overflow near 2^128.",
     .advice = "Nothing to do between 10^-28 and 10^30 W.",
     .mutations = {"power is no power of two"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
