#include "bench/app/memory_need.h"

#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/core/memory_use.h"
#include "shlm/block_costs.h"

namespace bench {
namespace {

constexpr double photon_bytes = sizeof(common::Vec3) + sizeof(photonmap::Photon);
constexpr double sorting_bytes = sizeof(photonmap::Photon) + sizeof(std::uint32_t);  // beside the photons
constexpr double flann_bytes = 46;              // bulk tree: 33 to 42 by leaf fill
constexpr double nanoflann_bytes = 12;          // 7 to 8 by leaf fill
constexpr double grid_bytes = 8;                // at most two cells a photon
constexpr double flann_incremental_bytes = 96;  // 75, and FLANN's array of pointers while it grows
constexpr double compact_photon_bytes = 26;     // 24, and partly filled pages while they are sorted
constexpr double wave_bytes = 64e6;             // hits on their way to a store, or to their cells

/// While an adaptive map is made: a pyramid of blocks, and for each what it costs and what becomes of it.
constexpr double pyramid_bytes =
    4.0 / 3 * (sizeof(shlm::LightBlock) + sizeof(shlm::BlockCosts) + 3 * sizeof(double));

/// While it is filled, and a finished map beside it with its index.
double texel_bytes(const ShlmMethod& method) {
    return with_model(method, [&](auto model) {
        using Model = decltype(model);
        const double filled = shlm::TexelSums<Model>::bytes_per_texel() + sizeof(shlm::TexelGeometry);
        if (method.basis == LightBasis::adaptive) return filled + pyramid_bytes;
        const double finished =
            sizeof(shlm::Texel<shlm::Harmonics<Model::order>>);  // halves are made from it
        return filled + (method.in_halves ? 2 : 1) * finished + 2 * sizeof(common::Vec3) +
               sizeof(std::uint32_t) + flann_bytes;
    });
}

/// At its fullest: while the photons are sorted, or with the index.
double photon_map_bytes_per_hit(PhotonMapEngine engine) {
    switch (engine) {
        case PhotonMapEngine::flann:
            return photon_bytes + std::max(sorting_bytes, flann_bytes);
        case PhotonMapEngine::nanoflann:
            return photon_bytes + std::max(sorting_bytes, nanoflann_bytes);
        case PhotonMapEngine::grid:
            return photon_bytes + std::max(sorting_bytes, grid_bytes);
        case PhotonMapEngine::compact:
            return compact_photon_bytes;
        case PhotonMapEngine::flann_incremental:
            break;
    }
    return photon_bytes + flann_incremental_bytes;
}

/// Photons that the engine's indices can count.
std::size_t most_photons(PhotonMapEngine engine) {
    switch (engine) {
        case PhotonMapEngine::nanoflann:
            return common::NanoflannIndex::max_points;
        case PhotonMapEngine::grid:
            return common::GridIndex::max_points;
        case PhotonMapEngine::compact:
            return common::CompactIndex::max_points;
        case PhotonMapEngine::flann:
        case PhotonMapEngine::flann_incremental:
            break;
    }
    return common::max_flann_points;
}

double gibibytes(std::size_t bytes) {
    return static_cast<double>(bytes) * 0x1p-30;
}

}  // namespace

std::size_t needed_bytes(const Method& method, const MethodSettings& settings, std::uint64_t hits) {
    const double bytes =
        method.light_map()
            ? static_cast<double>(PreparedMethods::texel_choice(*method.light_map(), settings).count) *
                  texel_bytes(*method.light_map())
            : static_cast<double>(hits) * photon_map_bytes_per_hit(method.photon_map()->engine);
    return static_cast<std::size_t>(bytes + wave_bytes);
}

std::string reason_to_skip(const Method& method, const MethodSettings& settings, std::uint64_t hits,
                           std::size_t max_bytes) {
    const std::size_t needed = needed_bytes(method, settings, hits);
    if (needed > max_bytes) return fmt::format("needs {:.1f} GiB", gibibytes(needed));
    if (const PhotonMapMethod* photon_map = method.photon_map()) {
        constexpr std::size_t last_wave = 1 << 20;  // a run ends a little past its number of hits
        const std::size_t most = most_photons(photon_map->engine);
        if (hits > most - last_wave) return fmt::format("the engine holds at most {} photons", most);
    }
    return "";
}

void require_memory(const Method& method, const MethodSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes) {
    const std::string reason = reason_to_skip(method, settings, hits, max_bytes);
    if (!reason.empty())
        throw common::InputError(
            fmt::format("{}: {}, {:.1f} GiB are free for it", method.name, reason, gibibytes(max_bytes)));
}

std::size_t default_max_bytes() {
    return common::available_bytes() / 10 * 9;
}

}  // namespace bench
