#include "shlm/deposit_sorter.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {

using common::HitBatch;

DepositSorter::DepositSorter(const TexelLayout& layout) : layout_(&layout) {
    while (layout.texel_count() > (max_shares << share_shift_)) ++share_shift_;
}

void DepositSorter::sort(std::span<const HitBatch> wave) {
    if (batches_.size() < wave.size()) batches_.resize(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { find_texels(wave[b], batches_[b]); });
    place_batches(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { scatter_to_shares(batches_[b]); });
    for (std::size_t b = 0; b < wave.size(); ++b) {
        rejected_ += batches_[b].rejected;
        clamped_ += batches_[b].clamped;
    }
}

void DepositSorter::find_texels(const HitBatch& hits, BatchDeposits& batch) const {
    batch.rejected = {};
    batch.clamped = {};
    batch.deposits.clear();
    batch.share_size.fill(0);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const common::SurfaceId& surface = hits.surface[i];
        const common::Vec3& direction = hits.direction[i];
        const TriangleTexels& triangle = layout_->triangle(surface.triangle);
        const float cosine = -direction.dot(triangle.normal);
        if (!common::is_finite(hits, i)) {
            ++batch.rejected.not_finite;
        } else if (triangle.width == 0) {
            ++batch.rejected.without_lightmap_uv;
        } else if (cosine < 0 && !triangle.both_faces) {
            ++batch.rejected.back_of_single_sided;
        } else {
            const float incident = std::abs(cosine);
            const float clamped = std::max(incident, common::min_incident_cosine);
            const float mean_flux = common::mean_component(hits.flux[i]);
            batch.clamped.flux += mean_flux;
            if (incident < clamped) batch.clamped.discarded += mean_flux * (1 - incident / clamped);
            const std::uint32_t texel = texel_at(triangle, surface.u, surface.v, cosine >= 0);
            batch.deposits.push_back({texel, -direction, 1 / clamped, hits.flux[i]});
            ++batch.share_size[share_of(texel)];
        }
    }
}

/// Within a share, batch follows batch: each texel gets its deposits in the order of their photons.
void DepositSorter::place_batches(std::size_t batch_count) {
    std::uint32_t next = 0;
    for (std::size_t share = 0; share < max_shares; ++share) {
        share_begin_[share] = next;
        for (std::size_t b = 0; b < batch_count; ++b) {
            batches_[b].share_begin[share] = next;
            next += batches_[b].share_size[share];
        }
    }
    share_begin_[max_shares] = next;
    if (by_share_.size() < next) by_share_.resize(next);
}

void DepositSorter::scatter_to_shares(BatchDeposits& batch) {
    for (const Deposit& deposit : batch.deposits)
        by_share_[batch.share_begin[share_of(deposit.texel)]++] = deposit;
}

std::size_t DepositSorter::bytes() const {
    std::size_t bytes = by_share_.capacity() * sizeof(Deposit);
    for (const BatchDeposits& batch : batches_)
        bytes += sizeof(batch) + batch.deposits.capacity() * sizeof(Deposit);
    return bytes;
}

}  // namespace shlm
