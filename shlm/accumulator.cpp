#include "shlm/accumulator.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

using common::HitBatch;
using common::Rgb;
using common::Vec3;

/// A texel's sums are asked for this many deposits before they are added to: about the time of a cache miss.
constexpr std::size_t prefetch_distance = 16;

}  // namespace

Accumulator::Accumulator(const TexelLayout& layout, ShWeight weight)
    : layout_(&layout), weight_(weight), sums_(layout.texel_count()) {
    while (layout.texel_count() > (max_shares << share_shift_)) ++share_shift_;
}

void Accumulator::consume(std::span<const HitBatch> wave) {
    if (batches_.size() < wave.size()) batches_.resize(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { find_texels(wave[b], batches_[b]); });
    place_batches(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { scatter_to_shares(batches_[b]); });
    tbb::parallel_for(std::size_t{0}, max_shares, [&](std::size_t share) { add_share(share); });
    for (std::size_t b = 0; b < wave.size(); ++b) rejected_ += batches_[b].rejected;
}

void Accumulator::find_texels(const HitBatch& hits, BatchDeposits& batch) const {
    batch.rejected = {};
    batch.deposits.clear();
    batch.share_size.fill(0);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const common::SurfaceId& surface = hits.surface[i];
        const Vec3& direction = hits.direction[i];
        const TriangleTexels& triangle = layout_->triangle(surface.triangle);
        const float cosine = -direction.dot(triangle.normal);
        if (!common::is_finite(hits, i)) {
            ++batch.rejected.not_finite;
        } else if (triangle.width == 0) {
            ++batch.rejected.without_lightmap_uv;
        } else if (cosine < 0 && !triangle.both_faces) {
            ++batch.rejected.back_of_single_sided;
        } else {
            const float weight = weight_ == ShWeight::flux
                                     ? 1.0f
                                     : 1.0f / std::max(std::abs(cosine), common::min_incident_cosine);
            const std::uint32_t texel = texel_at(triangle, surface.u, surface.v, cosine >= 0);
            batch.deposits.push_back({texel, -direction, hits.flux[i] * weight});
            ++batch.share_size[share_of(texel)];
        }
    }
}

/// Within a share, batch follows batch: each texel gets its deposits in the order of their photons.
void Accumulator::place_batches(std::size_t batch_count) {
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

void Accumulator::scatter_to_shares(BatchDeposits& batch) {
    for (const Deposit& deposit : batch.deposits)
        by_share_[batch.share_begin[share_of(deposit.texel)]++] = deposit;
}

void Accumulator::add_share(std::size_t share) {
    const std::span<const Deposit> deposits =
        std::span(by_share_).subspan(share_begin_[share], share_begin_[share + 1] - share_begin_[share]);
    for (std::size_t i = 0; i < deposits.size(); ++i) {
        if (i + prefetch_distance < deposits.size()) sums_.prefetch(deposits[i + prefetch_distance].texel);
        sums_.add(deposits[i].texel, deposits[i].towards_light, deposits[i].weight);
    }
}

std::size_t Accumulator::bytes() const {
    std::size_t bytes = sums_.bytes() + by_share_.capacity() * sizeof(Deposit);
    for (const BatchDeposits& batch : batches_)
        bytes += sizeof(batch) + batch.deposits.capacity() * sizeof(Deposit);
    return bytes;
}

}  // namespace shlm
