#include "photonmap/photon_storage.h"

#include <oneapi/tbb/parallel_for.h>

#include <vector>

#include "photonmap/finite_hits.h"
#include "photonmap/index/morton_order.h"

namespace photonmap {
void PhotonStorage::append(std::span<const common::HitBatch> wave) {
    std::span<common::Vec3> positions;
    std::span<Photon> photons;
    const std::size_t stored = store_finite_hits(
        wave,
        [&](std::size_t count) {
            positions = positions_.grow(count);
            photons = photons_.grow(count);
        },
        [&](std::size_t row, const common::HitBatch& batch, std::size_t i) {
            positions[row] = batch.position[i];
            photons[row] = {batch.direction[i], batch.flux[i], batch.surface[i].triangle};
        });
    rejected_.not_finite += common::count_hits(wave) - stored;
}

PhotonStorage PhotonStorage::sorted_along_curve() && {
    return std::move(*this).in_order(morton_order(positions()));
}

PhotonStorage PhotonStorage::in_order(std::span<const std::uint32_t> order) && {
    // Reserves no more than needed: valgrind has 128 GiB of addresses, too few for two full reservations.
    PhotonStorage sorted(std::max<std::size_t>(1, size()));
    sorted.rejected_ = rejected_;
    // Moves one column at a time and frees it at once, as the two copies limit how many photons fit.
    const auto move_column = [&](auto& sorted_column, auto& own_column) {
        const auto column = std::move(own_column);
        const auto out = sorted_column.grow(column.size());
        tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) { out[i] = column[order[i]]; });
    };
    move_column(sorted.positions_, positions_);
    move_column(sorted.photons_, photons_);
    return sorted;
}

}  // namespace photonmap
