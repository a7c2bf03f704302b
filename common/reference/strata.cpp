#include "common/reference/strata.h"

#include <utility>

namespace common::reference {
namespace {

constexpr std::uint32_t cells_across = 8;
static_assert(cells_across * cells_across == samples_per_pass);

/// The number after all samples, so that it shares no random numbers with them.
constexpr std::uint32_t pairing_stream = samples_per_pass;

/// Returns a random permutation, all equally likely (Fisher and Yates).
std::array<std::uint8_t, samples_per_pass> shuffled(RandomStream& stream) {
    std::array<std::uint8_t, samples_per_pass> order;
    for (std::uint32_t i = 0; i < samples_per_pass; ++i) order[i] = static_cast<std::uint8_t>(i);
    for (std::uint32_t left = samples_per_pass; left > 1; --left)
        std::swap(order[left - 1], order[static_cast<std::uint32_t>(stream.next() * left)]);
    return order;
}

std::array<double, 2> jittered(std::uint32_t cell, RandomStream& stream) {
    const double across = stream.next(), down = stream.next();
    return {(cell % cells_across + across) / cells_across, (cell / cells_across + down) / cells_across};
}

}  // namespace

PassStrata::PassStrata(std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass) {
    RandomStream stream(seed, pixel, pass, pairing_stream);
    on_light_ = shuffled(stream);
    which_light_ = shuffled(stream);
}

FirstNumbers PassStrata::numbers(std::uint32_t sample, RandomStream& stream) const {
    const std::array<double, 2> direction = jittered(sample, stream);
    const std::array<double, 2> on_light = jittered(on_light_[sample], stream);
    return {direction, on_light, (which_light_[sample] + stream.next()) / samples_per_pass};
}

}  // namespace common::reference
