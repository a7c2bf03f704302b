// Blocks of texels that share one light where there are few hits.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <bit>

#include "shlm/layout/block_surface.h"
#include "shlm/layout/prepared_texels.h"
#include "shlm/sums/texel_sums.h"

namespace shlm {

/// Divides each rectangle of texels into four recursively, and calls `show(texel, sum, area)` for all texels.
/// It passes the texel's own sum and covered area, or those of the largest block around it that has fewer
/// than `least_hits`. Sums are only spread, never increased or lost: the light of every block is preserved.
///
/// Of four texels with that many hits, one has none by accident with probability e^(-least_hits / 4). A texel
/// that is dark for a reason stays dark wherever light beside it has as many hits.
///
/// A block must be one surface (block_surface.h); otherwise its parts are shown separately. May call `show`
/// several times for a texel; the last call counts. May call it for different texels at once from several
/// threads.
template <class Model, class Show>
class TexelBlocks {
  public:
    TexelBlocks(const TexelSums<Model>& sums, const PreparedTexels& texels, std::uint64_t least_hits,
                Show show)
        : sums_(sums), texels_(texels), least_hits_(least_hits), show_(show) {}

    void show_all() const {
        const std::span<const TexelRegion> regions = texels_.layout.regions();
        tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) {
            const TexelRegion& region = regions[i];
            const std::uint32_t all = std::bit_ceil(std::max(region.width, region.height));
            const std::span geometry(texels_.geometry);
            const double width = texel_width(geometry.subspan(region.first_texel, region.texels_per_face()));
            show_block({region, region.first_texel_of(false), width}, 0, 0, all);
            if (region.both_faces) show_block({region, region.first_texel_of(true), width}, 0, 0, all);
        });
    }

  private:
    static constexpr std::uint32_t parallel_size = 128;  // smaller blocks are not tasks of their own

    struct Face {
        const TexelRegion& region;
        std::uint32_t first_texel;
        double texel_width;  ///< world units
    };

    struct Block {
        TexelSum<Model> sum;   ///< its values only in blocks with fewer than least_hits
        BlockSurface surface;  ///< only in those blocks, too
    };

    Block show_texel(std::uint32_t texel) const {
        const TexelGeometry& geometry = texels_.geometry[texel];
        const TexelSum<Model> sum = sums_[texel];
        show_(texel, sum, double{geometry.area});
        if (geometry.area == 0) return {};
        return {sum, BlockSurface::of_texel(geometry)};
    }

    Block show_block(const Face& face, std::uint32_t x, std::uint32_t y, std::uint32_t size) const {
        const TexelRegion& region = face.region;
        if (x >= region.width || y >= region.height) return {};
        if (size == 1) return show_texel(face.first_texel + y * region.width + x);

        const std::uint32_t half = size / 2;
        std::array<Block, 4> parts;
        const auto show_part = [&](std::uint32_t i) {
            parts[i] = show_block(face, x + (i % 2) * half, y + (i / 2) * half, half);
        };
        if (size >= parallel_size)
            tbb::parallel_for(0u, 4u, show_part);
        else
            for (std::uint32_t i = 0; i < 4; ++i) show_part(i);

        Block block;
        for (const Block& part : parts) block.sum.hits += part.sum.hits;
        if (block.sum.hits >= least_hits_) return block;
        for (const Block& part : parts)
            for (std::size_t k = 0; k < block.sum.value.size(); ++k) block.sum.value[k] += part.sum.value[k];
        const std::array surfaces = {parts[0].surface, parts[1].surface, parts[2].surface, parts[3].surface};
        block.surface = joined(surfaces, face.texel_width * size);
        if (block.sum.hits > 0 && block.surface.one)
            for (std::uint32_t row = y; row < std::min(y + size, region.height); ++row)
                for (std::uint32_t column = x; column < std::min(x + size, region.width); ++column)
                    show_(face.first_texel + row * region.width + column, block.sum, block.surface.area);
        return block;
    }

    const TexelSums<Model>& sums_;
    const PreparedTexels& texels_;
    std::uint64_t least_hits_;
    Show show_;
};

}  // namespace shlm
