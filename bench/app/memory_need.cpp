#include "bench/app/memory_need.h"

#include <fmt/format.h>

#include "common/core/memory_use.h"

namespace bench {
namespace {

constexpr double photon_bytes = sizeof(common::Vec3) + sizeof(photonmap::Photon);
constexpr double flann_bytes = 46;              // bulk tree: 33 to 42 by leaf fill
constexpr double flann_incremental_bytes = 96;  // 75, and FLANN's array of pointers while it grows
constexpr double texel_bytes = shlm::TexelSums::bytes_per_texel() + sizeof(shlm::TexelGeometry) +
                               sizeof(shlm::Texel) + 2 * sizeof(common::Vec3) + flann_bytes;
constexpr double wave_bytes = 64e6;  // hits on their way to a store

double gibibytes(std::size_t bytes) {
    return static_cast<double>(bytes) * 0x1p-30;
}

}  // namespace

std::size_t needed_bytes(std::string_view method, const MethodSettings& settings, std::uint64_t hits) {
    const auto count = static_cast<double>(hits);
    double bytes = 0;
    if (method == "photonmap/flann")
        bytes = count * (photon_bytes + flann_bytes);
    else if (method == "photonmap/flann-incremental")
        bytes = count * (photon_bytes + flann_incremental_bytes);
    else
        bytes = static_cast<double>(settings.shlm.texels) * texel_bytes;
    return static_cast<std::size_t>(bytes + wave_bytes);
}

std::string reason_to_skip(std::string_view method, const MethodSettings& settings, std::uint64_t hits,
                           std::size_t max_bytes) {
    const std::size_t needed = needed_bytes(method, settings, hits);
    if (needed > max_bytes) return fmt::format("needs {:.1f} GiB", gibibytes(needed));
    if (method.starts_with("photonmap/flann") && hits > common::max_flann_points - (1u << 20))
        return fmt::format("FLANN holds at most {} points", common::max_flann_points);
    return "";
}

void require_memory(std::string_view method, const MethodSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes) {
    const std::string reason = reason_to_skip(method, settings, hits, max_bytes);
    if (!reason.empty())
        throw common::InputError(
            fmt::format("{}: {}, {:.1f} GiB are free for it", method, reason, gibibytes(max_bytes)));
}

std::size_t default_max_bytes() {
    return common::available_bytes() / 10 * 9;
}

}  // namespace bench
