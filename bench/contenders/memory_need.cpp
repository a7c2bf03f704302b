#include "bench/contenders/memory_need.h"

#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/core/memory_use.h"

namespace bench {
namespace {

constexpr double wave_bytes = 64e6;  // hits on their way to a store, or to their cells

double gibibytes(std::size_t bytes) {
    return static_cast<double>(bytes) * 0x1p-30;
}

}  // namespace

std::size_t needed_bytes(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits) {
    return static_cast<std::size_t>(contender->needed_bytes(settings, hits) + wave_bytes);
}

std::string reason_to_skip(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits,
                           std::size_t max_bytes) {
    const std::size_t needed = needed_bytes(contender, settings, hits);
    if (needed > max_bytes) return fmt::format("needs {:.1f} GiB", gibibytes(needed));
    constexpr std::size_t last_wave = 1 << 20;  // a run ends a little past its number of hits
    const std::size_t most = contender->most_photons();
    if (hits > most - last_wave) return fmt::format("the engine holds at most {} photons", most);
    return "";
}

void require_memory(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes) {
    const std::string reason = reason_to_skip(contender, settings, hits, max_bytes);
    if (!reason.empty())
        throw common::InputError(
            fmt::format("{}: {}, {:.1f} GiB are free for it", contender.name, reason, gibibytes(max_bytes)));
}

std::size_t default_max_bytes() {
    return common::available_bytes() / 10 * 9;
}

}  // namespace bench
