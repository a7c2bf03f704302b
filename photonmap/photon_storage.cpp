#include "photonmap/photon_storage.h"

#include <oneapi/tbb/parallel_for.h>

#include <vector>

#include "common/point_index/morton_order.h"
#include "photonmap/finite_hits.h"

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
    const PhotonStorage unsorted = std::move(*this);  // given back on return: an index is built next
    const std::vector<std::uint32_t> order = common::morton_order(unsorted.positions());
    PhotonStorage sorted;
    sorted.rejected_ = unsorted.rejected_;
    const std::span<common::Vec3> positions = sorted.positions_.grow(unsorted.size());
    const std::span<Photon> photons = sorted.photons_.grow(unsorted.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
        positions[i] = unsorted.positions_[order[i]];
        photons[i] = unsorted.photons_[order[i]];
    });
    return sorted;
}

}  // namespace photonmap
