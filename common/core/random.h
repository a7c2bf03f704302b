// Counter-based random numbers: the same photon gets the same numbers in every run, on any thread.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace common {

/// What a block of random numbers is for; no two purposes share numbers.
enum class RandomPurpose : std::uint32_t {
    emission_origin,
    emission_direction,
    scattering,
    looking,
    scramble_of_origin,
    scramble_of_direction
};

/// Returns 128 random bits as a pure function of the arguments: Philox4x32-10 (Salmon et al.,
/// "Parallel Random Numbers: As Easy as 1, 2, 3", 2011). The key is the seed; the counter is the photon, the
/// event along its path and the purpose.
inline std::array<std::uint32_t, 4> random_bits(std::uint64_t seed, std::uint64_t photon, std::uint32_t event,
                                                RandomPurpose purpose) {
    const r123::Philox4x32::ctr_type counter = {{static_cast<std::uint32_t>(photon),
                                                 static_cast<std::uint32_t>(photon >> 32), event,
                                                 static_cast<std::uint32_t>(purpose)}};
    const r123::Philox4x32::key_type key = {
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const auto bits = r123::Philox4x32{}(counter, key);
    return {bits[0], bits[1], bits[2], bits[3]};
}

/// Returns the same as four numbers in [0, 1).
inline std::array<float, 4> random_uniforms(std::uint64_t seed, std::uint64_t photon, std::uint32_t event,
                                            RandomPurpose purpose) {
    const auto bits = random_bits(seed, photon, event, purpose);
    std::array<float, 4> u;
    // 24 bits fill a float's mantissa: scaling all 32 would round some up to 1.0.
    for (std::size_t i = 0; i < 4; ++i) u[i] = static_cast<float>(bits[i] >> 8) * 0x1p-24f;
    return u;
}

}  // namespace common
