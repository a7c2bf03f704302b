// 13. Random numbers: a generator with a short period traces the same photons again.
#include <array>
#include <numeric>
#include <random>

#include "bench/experiments/stability/stability_case.h"
#include "common/core/random.h"

namespace bench::stability {
namespace {

/// C++'s std::minstd_rand: x becomes 48271 x modulo the prime 2^31 - 1, which visits all 2^31 - 2 values but
/// 0.
constexpr std::uint64_t modulus = std::minstd_rand::modulus, period = modulus - 1;

constexpr std::uint64_t power(std::uint64_t base, std::uint64_t exponent) {
    std::uint64_t result = 1;
    for (; exponent > 0; exponent /= 2, base = base * base % modulus)
        if (exponent % 2 == 1) result = result * base % modulus;
    return result;
}

/// Each photon takes the next `draws` numbers of the seed's single sequence. They repeat when photons * draws
/// is a multiple of the period: first after period / gcd(period, draws) photons.
constexpr std::uint64_t photons_until_repeated(std::uint64_t draws) {
    return period / std::gcd(period, draws);
}

template <std::size_t Draws>
std::array<std::uint32_t, Draws> minstd_photon(std::uint64_t seed, std::uint64_t photon) {
    // Jumps ahead to the photon's first number.
    std::minstd_rand engine(static_cast<std::uint32_t>(
        seed * power(std::minstd_rand::multiplier, photon % period * Draws % period) % modulus));
    std::array<std::uint32_t, Draws> numbers;
    for (std::uint32_t& number : numbers) number = static_cast<std::uint32_t>(engine());
    return numbers;
}

/// Returns all numbers that this program draws for a photon up to its first bounce.
std::array<std::array<float, 4>, 3> our_photon(std::uint64_t seed, std::uint64_t photon) {
    using enum common::RandomPurpose;
    return {common::random_uniforms(seed, photon, 0, emission_origin),
            common::random_uniforms(seed, photon, 0, emission_direction),
            common::random_uniforms(seed, photon, 0, scattering)};
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double distances[] = {photons_until_repeated(9),
                                    static_cast<double>(period / 8),
                                    photons_until_repeated(8),
                                    static_cast<double>(period),
                                    0x1p32,
                                    0x1p40};
    const bool truncated = run.has_mutation("photons are counted in 32 bits");
    const bool no_divisor = run.has_mutation("periods and draws have no common divisor");
    const auto repeats = [&](std::uint64_t draws) {
        return [=](double distance) {
            const std::uint64_t first = no_divisor ? period : photons_until_repeated(draws);
            return static_cast<std::uint64_t>(distance) % first == 0 ? 1.0 : 0.0;
        };
    };
    std::vector<StabilityCurve> curves = {curve_at("minstd, 8 numbers a photon", distances, repeats(8)),
                                          curve_at("minstd, 9 numbers a photon", distances, repeats(9)),
                                          curve_at("ours, Philox", distances, [](double) { return 0.0; })};
    run.for_each_seed([&](std::uint64_t seed) {
        const std::uint64_t photons = run.either<std::uint64_t>(100'000, 2'000);
        for (std::size_t i = 0; i < std::size(distances); ++i) {
            const auto distance = static_cast<std::uint64_t>(distances[i]);
            const auto equal = [&](const auto& photon_at) {
                std::uint64_t count = 0;
                for (std::uint64_t p = 0; p < photons; ++p)
                    count += photon_at(seed, p) == photon_at(seed, p + distance);
                return static_cast<double>(count) / static_cast<double>(photons);
            };
            curves[0].points[i].measured.push_back(equal(minstd_photon<8>));
            curves[1].points[i].measured.push_back(equal(minstd_photon<9>));
            curves[2].points[i].measured.push_back(equal([&](std::uint64_t s, std::uint64_t p) {
                return our_photon(s, truncated ? static_cast<std::uint32_t>(p) : p);
            }));
        }
    });
    return curves;
}

const RegisteredCase registered(
    130,
    {.name = "random-period",
     .purpose = "A run that has used up its generator's period traces the same photons again: its noise "
                "stops to fall, in every store alike.",
     .scene = "No scene: the numbers of a photon beside those of the photon that comes a swept distance "
              "later. Seeds start the sequences.",
     .swept = "photons between the two",
     .measured = "part of the photons that are the same",
     .theory =
         "std::minstd_rand repeats after 2^31 - 2 numbers. Photons of d numbers repeat after (2^31 - 2) / "
         "gcd(2^31 - 2, d) photons: 239 million for d = 9; for d = 8, where all numbers have been used "
         "after 268 million, they come shifted by six, and whole photons repeat after 1074 million. "
         "Numbers that are a function of seed and photon number do not repeat below 2^64 photons.",
     .advice = "Nothing to do: photons are numbered with 64 bits. Where numbers come from a sequence, its "
               "period must be far beyond photons x numbers.",
     .mutations = {"photons are counted in 32 bits", "periods and draws have no common divisor"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
