#include "photonmap/photon_storage.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "common/point_index/morton_order.h"

namespace photonmap {
namespace {

std::size_t count_finite(const common::HitBatch& batch) {
    std::size_t finite = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) finite += common::is_finite(batch, i);
    return finite;
}

}  // namespace

void PhotonStorage::append(std::span<const common::HitBatch> wave) {
    // Where each batch begins follows from the counts before it, so the order does not depend on the threads.
    std::vector<std::size_t> begin(wave.size() + 1, 0);
    tbb::parallel_for(std::size_t{0}, wave.size(),
                      [&](std::size_t b) { begin[b + 1] = count_finite(wave[b]); });
    for (std::size_t b = 0; b < wave.size(); ++b) begin[b + 1] += begin[b];

    const std::span<common::Vec3> positions = positions_.grow(begin.back());
    const std::span<Photon> photons = photons_.grow(begin.back());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) {
        const common::HitBatch& batch = wave[b];
        std::size_t out = begin[b];
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (!common::is_finite(batch, i)) continue;
            positions[out] = batch.position[i];
            photons[out] = {batch.direction[i], batch.flux[i], batch.surface[i].triangle};
            ++out;
        }
    });
    rejected_.not_finite += common::count_hits(wave) - begin.back();
}

PhotonStorage PhotonStorage::sorted_along_curve() && {
    const PhotonStorage unsorted = std::move(*this);  // given back on return: an index is built next
    const std::vector<std::uint32_t> order = common::morton_order(unsorted.positions());
    // No more room than it takes: valgrind has 128 GiB of addresses, too few to reserve the most for both.
    PhotonStorage sorted(std::max<std::size_t>(1, unsorted.size()));
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
