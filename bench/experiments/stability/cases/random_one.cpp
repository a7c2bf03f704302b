// 13. Random numbers: a number that should be below 1 and is rounded to 1.
#include <Random123/philox.h>

#include <cmath>

#include "bench/experiments/stability/stability_case.h"
#include "common/core/random.h"

namespace bench::stability {
namespace {

constexpr double draws = 1e9;

float scaled(std::uint32_t number, int bits) {
    return static_cast<float>(number) * std::ldexp(1.0f, -bits);
}

/// Returns how many of the numbers of `bits` bits become 1. Rounding is monotonic, so it suffices to go down
/// from the largest to the first that stays below 1; `all` tests each one.
std::uint64_t become_one(int bits, bool all) {
    const std::uint64_t numbers = std::uint64_t{1} << bits;
    std::uint64_t count = 0;
    for (std::uint64_t from_top = 1; from_top <= numbers; ++from_top) {
        const bool one = scaled(static_cast<std::uint32_t>(numbers - from_top), bits) == 1.0f;
        count += one;
        if (!one && !all) break;
    }
    return count;
}

/// Photons whose first number for the direction of emission is one of the 128 numbers of 32 bits that round
/// to 1, with seed 1. They were found by trying photons one after the other.
constexpr std::uint64_t unlucky_photons[] = {10'223'920, 50'799'660, 123'861'278};

/// Returns the word from which common::random_uniforms makes its first number.
std::uint32_t philox_word(std::uint64_t photon) {
    const auto purpose = static_cast<std::uint32_t>(common::RandomPurpose::emission_direction);
    return r123::Philox4x32{}({{static_cast<std::uint32_t>(photon), 0, 0, purpose}}, {{1, 0}})[0];
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double bits[] = {16, 20, 23, 24, 25, 26, 28, 30, 31, 32}, ours[] = {24};
    const double share = run.has_mutation("the whole last step rounds up") ? 0x1p-24 : 0x1p-25;
    const bool keeps_all = run.has_mutation("all 32 bits are kept");
    std::vector<StabilityCurve> curves = {
        // Floats below 1 are 2^-24 apart. Numbers within half of that from 1, including the tie, are rounded
        // up.
        curve_at("b random bits, as a float", bits, [&](double b) { return b > 24 ? share * draws : 0; }),
        curve_at("ours, on unlucky photons", ours, [](double) { return 0.0; })};
    for (StabilityPoint& point : curves[0].points) {
        const int b = static_cast<int>(point.at);
        const auto ones = static_cast<double>(become_one(b, run.full() || b <= 24));
        point.measured.push_back(std::ldexp(ones, -b) * draws);
    }
    double ones = 0;
    for (const std::uint64_t photon : unlucky_photons) {
        const auto purpose = common::RandomPurpose::emission_direction;
        ones += (keeps_all ? scaled(philox_word(photon), 32)
                           : common::random_uniforms(1, photon, 0, purpose)[0]) == 1.0f;
    }
    curves[1].points[0].measured.push_back(ones / std::size(unlucky_photons) * draws);
    return curves;
}

const RegisteredCase registered(
    131,
    {.name = "random-one",
     .purpose =
         "Random bits that are scaled to [0, 1) and rounded to a float can become 1: a cosine of 0, an "
         "index past the end of a table, the logarithm of 0, once in some ten million draws.",
     .scene = "No scene: all numbers of b bits, and photons of ours whose numbers would become 1. Nothing is "
              "random.",
     .swept = "random bits b in a number",
     .measured = "numbers that become 1, in 10^9",
     .theory =
         "Floats below 1 are 2^-24 apart, so all above 1 - 2^-25 and that itself (ties go to even) become "
         "1: 2^-25 of all numbers from 25 bits on, 29.8 in 10^9; none up to 24 bits.",
     .advice = "Nothing to do: the tracer keeps the upper 24 bits.",
     .mutations = {"the whole last step rounds up", "all 32 bits are kept"},
     .run = run});

}  // namespace
}  // namespace bench::stability
