#include "bench/app/reference_target.h"

#include <algorithm>
#include <cmath>

#include "bench/setup/numbers.h"
#include "common/core/input_error.h"
#include "common/reference/strata.h"

namespace bench {
namespace {

using common::InputError;
using common::reference::samples_per_pass;

}  // namespace

bool ReferenceTarget::reached(std::uint64_t passes_done, double error) const {
    if (passes > 0) return passes_done >= passes;
    return passes_done > 0 && passes_done % passes_between_looks == 0 && error <= relative_error;
}

std::uint64_t ReferenceTarget::expected_passes(std::uint64_t passes_done, double error) const {
    if (passes > 0) return passes;
    // The error falls with the square root of the number of passes.
    const double shortfall = std::min(error / relative_error, 1e4);
    const double wanted = std::max(1.0, shortfall * shortfall) *
                          static_cast<double>(std::max(passes_done, passes_between_looks));
    const auto looks = static_cast<std::uint64_t>(std::ceil(wanted / passes_between_looks));
    return looks * passes_between_looks;
}

ReferenceTarget reference_target(const std::string& spp, const std::string& until) {
    if (!spp.empty() && !until.empty()) throw InputError("--spp and --until exclude each other");
    if (!until.empty()) return {.relative_error = parse_percentage("--until", until)};
    const std::uint64_t samples = spp.empty() ? 1024 : parse_count("--spp", spp);
    constexpr std::uint64_t most_samples = std::uint64_t{1} << 36;  // passes are counted in 32 bits
    if (samples > most_samples) throw InputError("--spp: at most 68719476736");
    return {.passes = std::max(fewest_passes, (samples + samples_per_pass - 1) / samples_per_pass)};
}

}  // namespace bench
