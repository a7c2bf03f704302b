// 10. Accumulation: float sums that stop growing one after the other give an impossible direction of light.
#include <numbers>

#include "bench/contenders/plain_sums.h"
#include "bench/experiments/stability/float_sums.h"
#include "bench/experiments/stability/stability_case.h"
#include "shlm/basis/texel_model.h"

namespace bench::stability {
namespace {

using Model = shlm::TexelModel<1, shlm::ShWeight::radiance>;

constexpr float watts = 1.5f;                    // of each hit, head on from +z
constexpr std::size_t flat = 0, upward = 3 * 2;  // red of the harmonics Y00 and Y10 in a texel's sums

const shlm::Quantum light({watts, watts, watts});

/// Returns what a hit adds to number k.
float of_hit(std::size_t k) {
    return Model::of_hit({0, 0, 1}, 1)[k / 3] * watts;
}

/// Returns |L1| / (sqrt(3) L0). It is 1 where all light comes from one direction, and never more, as each hit
/// has |L1| = sqrt(3) L0.
double directedness(double upward_sum, double flat_sum) {
    return upward_sum / (std::numbers::sqrt3 * flat_sum);
}

/// Measures the directedness after each number of hits, in ascending order.
template <class Sums, class Value>
void measure(std::span<const double> numbers_of_hits, Value value, StabilityCurve& curve) {
    Sums sums(1, light);
    std::uint64_t added = 0;
    for (std::size_t i = 0; i < numbers_of_hits.size(); ++i) {
        for (; added < static_cast<std::uint64_t>(numbers_of_hits[i]); ++added)
            sums.add(0, {0, 0, 1}, 1, {watts, watts, watts});
        curve.points[i].measured = {directedness(value(sums, upward), value(sums, flat))};
    }
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const std::vector<double> places = run.either<std::vector<double>>(
        {1e4, 1e5, 3e5, 1e6, 3e6, 1e7, 3e7, 1e8, 3e8}, {1e4, 1e5, 3e5, 1e6, 3e6, 1e7, 3e7});
    const auto one = [](double) { return 1.0; };
    const bool infinite = run.has_mutation("floats never round");
    std::vector<StabilityCurve> curves = {
        curve_at(
            "float", places,
            [&](double n) {
                return infinite ? 1
                                : directedness(float_sum_of_equal_adds(of_hit(upward), n),
                                               float_sum_of_equal_adds(of_hit(flat), n));
            },
            Expected::equal, 2 * allowed_of_float_sum),
        // Either number is off by half a quantum, 2^-25 of at most 1.5 W, and by three roundings of 2^-24 to
        // a float.
        curve_at("light map", places, one, Expected::equal, 0x1p-24 / of_hit(flat) + 6 * 0x1p-24)};
    const auto of_plain = [](const auto& sums, std::size_t k) { return sums.value(0, k); };
    const auto of_ours = [](const auto& sums, std::size_t k) { return sums[0].value[k]; };
    measure<PlainSums<Model, float>>(places, of_plain, curves[0]);
    if (run.has_mutation("the light map sums floats"))
        measure<PlainSums<Model, float>>(places, of_plain, curves[1]);
    else
        measure<shlm::TexelSums<Model>>(places, of_ours, curves[1]);
    return curves;
}

const RegisteredCase registered(
    101,
    {.name = "float-harmonics",
     .purpose = "Sums of many hits on one texel: where a float stops depends on what it adds, so the "
                "harmonics stop one after the other and say what no light can.",
     .scene = "One texel that takes hits of 1.5 W, head on, one after the other. Nothing depends on a "
              "seed.",
     .swept = "hits on the texel: N",
     .measured = "|L1| / (sqrt(3) L0)",
     .theory = "1, the most that there can be, for light of one direction. Floats add 0.423 W to L0, which "
               "stops at 2^23, and 0.733 W to L1, which stops at 2^24: 2 / sqrt(3) = 1.155 in the end.",
     .advice = "No remedy needed in the light map: its sums are integers, 32 bits drained into 64.",
     .mutations = {"floats never round", "the light map sums floats"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
