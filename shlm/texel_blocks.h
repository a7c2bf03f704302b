// Texels that few hits have met show what their neighbourhood has: blocks that share one light.
#pragma once

#include <Imath/ImathVec.h>
#include <oneapi/tbb/parallel_for.h>

#include <bit>

#include "shlm/prepared_texels.h"
#include "shlm/texel_sums.h"

namespace shlm {

/// Divides each rectangle of texels into four again and again, and calls `show(texel, sum, area)` for all
/// texels: with its own sum and covered area, or with those of the largest block around it that holds fewer
/// than `least_hits`. Sums are spread and never added to or lost: the light of every block stays what it is.
///
/// Among four texels with that many hits one has none by accident with probability e^(-least_hits / 4); what
/// is dark for a reason stays dark wherever light beside it has as many.
///
/// Blocks are of one surface: where one bends by more than `same_block_cosine`, or joins what lies further
/// apart than it is wide, its parts are shown by themselves. May call `show` several times for a texel, the
/// last one counts; different texels at once from several threads.
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
            if (region.texels_per_face() == 0) return;
            const std::uint32_t all = std::bit_ceil(std::max(region.width, region.height));
            Face face{region, region.first_texel, texel_width(region)};
            show_block(face, 0, 0, all);
            if (!region.both_faces) return;
            face.first_texel += region.texels_per_face();
            show_block(face, 0, 0, all);
        });
    }

  private:
    /// Parts of a block may face away from its mean by 25 degrees.
    static constexpr double same_block_cosine = 0.9;
    static constexpr std::uint32_t parallel_size = 128;  // of a block: smaller ones are no task of their own

    struct Face {
        const TexelRegion& region;
        std::uint32_t first_texel;
        double texel_width;  ///< world units
    };

    struct Block {
        TexelSum<Model> sum;
        // These, and the sum's values, of blocks with fewer than least_hits alone:
        bool one_surface = true;
        double area = 0;             ///< world units squared; 0: no triangle covers any of it
        Imath::V3d center{0, 0, 0};  ///< times area
        Imath::V3d normal{0, 0, 0};  ///< times area
    };

    /// Of a texel that is covered whole.
    [[nodiscard]] double texel_width(const TexelRegion& region) const {
        float largest = 0;
        for (std::uint32_t i = 0; i < region.texels_per_face(); ++i)
            largest = std::max(largest, texels_.geometry[region.first_texel + i].area);
        return std::sqrt(double{largest});
    }

    Block show_texel(std::uint32_t texel) const {
        const TexelGeometry& geometry = texels_.geometry[texel];
        const TexelSum<Model> sum = sums_[texel];
        show_(texel, sum, double{geometry.area});
        if (geometry.area == 0) return {};
        return {.sum = sum,
                .area = geometry.area,
                .center = Imath::V3d(geometry.center) * geometry.area,
                .normal = Imath::V3d(geometry.normal) * geometry.area};
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
        join(parts, face.texel_width * size, block);
        if (block.sum.hits > 0 && block.one_surface)
            for (std::uint32_t row = y; row < std::min(y + size, region.height); ++row)
                for (std::uint32_t column = x; column < std::min(x + size, region.width); ++column)
                    show_(face.first_texel + row * region.width + column, block.sum, block.area);
        return block;
    }

    /// `width` of the block, world units.
    static void join(const std::array<Block, 4>& parts, double width, Block& block) {
        for (const Block& part : parts) {
            for (std::size_t k = 0; k < block.sum.value.size(); ++k) block.sum.value[k] += part.sum.value[k];
            block.area += part.area;
            block.center += part.center;
            block.normal += part.normal;
        }
        for (const Block& part : parts) {
            if (part.area == 0) continue;
            const double cosine =
                part.normal.dot(block.normal) / (part.normal.length() * block.normal.length());
            const double apart = (part.center / part.area - block.center / block.area).length();
            block.one_surface =
                block.one_surface && part.one_surface && cosine >= same_block_cosine && apart <= width;
        }
    }

    const TexelSums<Model>& sums_;
    const PreparedTexels& texels_;
    std::uint64_t least_hits_;
    Show show_;
};

}  // namespace shlm
