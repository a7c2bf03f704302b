#include "shlm/sums/deposit_sorter.h"

#include <utility>

namespace shlm {

using common::HitBatch;

DepositSorter::DepositSorter(const TexelLayout& layout, const Quantum& quantum)
    : layout_(&layout), clamped_light_per_flux_(static_cast<float>(1 / quantum.clamped_light_unit())) {
    while (layout.texel_count() > (max_shares << share_shift_)) ++share_shift_;
}

void DepositSorter::sort(const HitBatch& hits) {
    find_texels(hits);
    deal_out();
}

void DepositSorter::find_texels(const HitBatch& hits) {
    constexpr std::size_t prefetch_distance = 16;
    deposits_.resize(hits.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (i + prefetch_distance < hits.size())
            __builtin_prefetch(&layout_->triangle(hits.surface[i + prefetch_distance].triangle));
        const common::SurfaceId& surface = hits.surface[i];
        const TriangleTexels& triangle = layout_->triangle(surface.triangle);
        const float cosine = -hits.direction[i].dot(triangle.normal);
        if (!common::is_finite(hits, i)) {
            ++rejected_.not_finite;
        } else if (triangle.width == 0) {
            ++rejected_.without_texel;
        } else if (cosine < 0 && !triangle.both_faces) {
            ++rejected_.back_of_single_sided;
        } else {
            const float incident = std::abs(cosine);
            const float clamped = std::max(incident, common::min_incident_cosine);
            clamped_.add(common::mean_component(hits.flux[i]) * clamped_light_per_flux_, incident);
            deposits_[next++] = {static_cast<std::uint32_t>(i),
                                 texel_at(triangle, surface.u, surface.v, cosine >= 0), 1 / clamped};
        }
    }
    deposits_.resize(next);
}

void DepositSorter::deal_out() {
    std::array<std::uint32_t, max_shares> next{};
    for (const Deposit& deposit : deposits_) ++next[share_of(deposit.texel)];
    std::uint32_t begin = 0;
    for (std::size_t share = 0; share < max_shares; ++share) {
        share_begin_[share] = begin;
        begin += std::exchange(next[share], begin);
    }
    share_begin_[max_shares] = begin;
    by_share_.resize(deposits_.size());
    for (const Deposit& deposit : deposits_) by_share_[next[share_of(deposit.texel)]++] = deposit;
}

}  // namespace shlm
