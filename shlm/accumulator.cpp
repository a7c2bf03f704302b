#include "shlm/accumulator.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

using common::HitBatch;
using common::Rgb;
using common::Vec3;

/// Texels are dealt to threads in this many contiguous shares, at most. A share belongs to one thread at a time, so sums
/// need no atomics; there are more shares than threads so that unequal ones even out.
constexpr std::size_t max_shares = 64;

/// A texel's sums are asked for this many deposits before they are added to: about the time of a cache miss.
constexpr std::size_t prefetch_distance = 8;

void prefetch(const TexelSum& sum) {
    const char* address = reinterpret_cast<const char*>(&sum);
    for (std::size_t line = 0; line < sizeof(TexelSum); line += 64) __builtin_prefetch(address + line, 1);
}

void add(TexelSum& sum, const Vec3& towards_light, const Rgb& weight) {
    const ShValues y = evaluate_sh(towards_light);
    std::array<float, 3 * coefficient_count> product;
    for (std::size_t i = 0; i < coefficient_count; ++i)
        for (int c = 0; c < 3; ++c) product[3 * i + c] = y[i] * weight[c];
    for (std::size_t i = 0; i < product.size(); ++i) sum.coefficient[i] += product[i];
    ++sum.hits;
}

}  // namespace

Accumulator::Accumulator(const TexelLayout& layout, ShWeight weight)
    : layout_(&layout), weight_(weight), sums_(layout.texel_count()) {
    while ((layout.texel_count() >> share_shift_) >= max_shares) ++share_shift_;
    share_count_ = (layout.texel_count() >> share_shift_) + 1;
}

void Accumulator::consume(std::span<const HitBatch> wave) {
    if (sorted_.size() < wave.size()) sorted_.resize(wave.size());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) { sort_by_share(wave[b], sorted_[b]); });
    tbb::parallel_for(std::size_t{0}, share_count_, [&](std::size_t share) { add_share(share, wave.size()); });
    for (std::size_t b = 0; b < wave.size(); ++b) rejected_ += sorted_[b].rejected;
}

void Accumulator::sort_by_share(const HitBatch& batch, SortedBatch& sorted) const {
    sorted.rejected = {};
    sorted.deposits.clear();
    sorted.share_begin.assign(share_count_ + 1, 0);
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const common::SurfaceId& surface = batch.surface[i];
        const Vec3& direction = batch.direction[i];
        const TriangleTexels& triangle = layout_->triangle(surface.triangle);
        const float cosine = -direction.dot(triangle.normal);
        if (!common::is_finite(direction) || !common::is_finite(batch.flux[i])) {
            ++sorted.rejected.not_finite;
        } else if (triangle.width == 0) {
            ++sorted.rejected.without_lightmap_uv;
        } else if (cosine < 0 && !triangle.both_faces) {
            ++sorted.rejected.back_of_single_sided;
        } else {
            const float weight =
                weight_ == ShWeight::flux ? 1.0f : 1.0f / std::max(std::abs(cosine), common::min_incident_cosine);
            const std::uint32_t texel = texel_at(triangle, surface.u, surface.v, cosine >= 0);
            sorted.deposits.push_back({texel, -direction, batch.flux[i] * weight});
            ++sorted.share_begin[share_of(texel) + 1];
        }
    }
    // Counting sort: stable, so each texel's deposits stay in order.
    for (std::size_t s = 0; s < share_count_; ++s) sorted.share_begin[s + 1] += sorted.share_begin[s];
    std::array<std::uint32_t, max_shares + 1> next;
    std::copy(sorted.share_begin.begin(), sorted.share_begin.end(), next.begin());
    sorted.by_share.resize(sorted.deposits.size());
    for (const Deposit& deposit : sorted.deposits) sorted.by_share[next[share_of(deposit.texel)]++] = deposit;
}

void Accumulator::add_share(std::size_t share, std::size_t batches) {
    for (std::size_t b = 0; b < batches; ++b) {
        const std::uint32_t begin = sorted_[b].share_begin[share], end = sorted_[b].share_begin[share + 1];
        const std::span<const Deposit> deposits = std::span(sorted_[b].by_share).subspan(begin, end - begin);
        for (std::size_t i = 0; i < deposits.size(); ++i) {
            if (i + prefetch_distance < deposits.size()) prefetch(sums_[deposits[i + prefetch_distance].texel]);
            add(sums_[deposits[i].texel], deposits[i].towards_light, deposits[i].weight);
        }
    }
}

std::size_t Accumulator::bytes() const {
    std::size_t bytes = sums_.capacity() * sizeof(TexelSum);
    for (const SortedBatch& s : sorted_)
        bytes += (s.deposits.capacity() + s.by_share.capacity()) * sizeof(Deposit) +
                 s.share_begin.capacity() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace shlm
