#include "common/tracer/trace_report.h"

#include <fmt/format.h>

#include <array>

#include "common/core/input_error.h"

namespace common {

void PhotonFates::add(std::span<const PhotonFate> photons) {
    std::array<std::uint64_t, 5> count{};
    for (const PhotonFate fate : photons) ++count[static_cast<std::size_t>(fate)];
    emitted += photons.size();
    missed += count[static_cast<std::size_t>(PhotonFate::missed)];
    escaped += count[static_cast<std::size_t>(PhotonFate::escaped)];
    absorbed += count[static_cast<std::size_t>(PhotonFate::absorbed)];
    given_up += count[static_cast<std::size_t>(PhotonFate::given_up)];
    without_light += count[static_cast<std::size_t>(PhotonFate::without_light)];
}

PhotonFates& PhotonFates::operator+=(const PhotonFates& other) {
    emitted += other.emitted;
    missed += other.missed;
    escaped += other.escaped;
    absorbed += other.absorbed;
    given_up += other.given_up;
    without_light += other.without_light;
    return *this;
}

void check_that_photons_hit(const TraceReport& so_far, const TraceTarget& target) {
    constexpr std::uint64_t patience = 1 << 20;
    if (target.hits > 0 && so_far.hits == 0 && so_far.fates.emitted >= patience)
        throw InputError(
            fmt::format("the first {} photons made no hit to record: no number of hits can be reached",
                        so_far.fates.emitted));
}

}  // namespace common
