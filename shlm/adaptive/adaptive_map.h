// A light map of blocks: each as large as its light lets it, and with no more numbers than its light needs.
#pragma once

#include "common/estimator/irradiance_estimator.h"
#include "shlm/adaptive/block_search.h"
#include "shlm/layout/texel_places.h"
#include "shlm/map/gather.h"

namespace shlm {

/// Immutable. Made from the sums of a light map whose texels are its smallest blocks: hits are taken in
/// constant time and memory as ever, and what the map needs is decided when it is finished. It needs nothing
/// else then.
class AdaptiveMap {
  public:
    /// `search.smallest(wanted_error)`. `layout`: of the sums that were searched. `smooth`: neighbouring
    /// blocks run into each other, as in Bilinear, over the width of the smaller; otherwise each shows one
    /// light. Throws InputError where there are more blocks than can be counted.
    AdaptiveMap(const BlockSearch& search, const TexelLayout& layout, double wanted_error, bool smooth);

    /// Irradiance for the shading normal, W/m^2. Never negative. Zero where no block answers.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const;

    [[nodiscard]] std::size_t bytes() const;

    /// Relative root mean square over the scene's surface, each part for the normals that its material has:
    /// sqrt(mean of (error)^2 / (irradiance^2 + epsilon)), epsilon = 0.01 (mean irradiance)^2. Of constant
    /// blocks: smooth ones have less.
    [[nodiscard]] double estimated_error() const { return estimated_error_; }

    /// Whose light a point shows, were the map not smooth. Nothing where no block answers.
    struct BlockAt {
        BlockKind kind;
        std::uint32_t width;  ///< texels a side
    };
    [[nodiscard]] std::optional<BlockAt> block_at(const common::SurfacePoint& point) const;

    /// How many blocks there are of each kind.
    [[nodiscard]] const std::array<std::size_t, block_kinds>& blocks() const { return blocks_; }

  private:
    /// Up to 4 nodes behind each other, those of a divided block; or a block: bit 31, three bits of kind, and
    /// where its numbers begin.
    using Node = std::uint32_t;

    struct Face {
        Node root = 0;
        /// Packed, for all its blocks. No normal is packed as this one: they keep their own.
        std::array<std::uint16_t, 2> normal{0xffff, 0xffff};

        [[nodiscard]] bool has_one_normal() const { return normal[0] != 0xffff; }
    };

    struct Found {
        Node node;
        std::uint32_t x, y, size;  ///< in texels of the region
    };

    struct Draft;
    class Drawing;

    [[nodiscard]] std::size_t face_index(std::uint32_t region, bool back) const {
        return region + (back ? places_.region_count() : 0);
    }
    [[nodiscard]] Found find(const Face& face, const TexelRegion& region, std::uint32_t x,
                             std::uint32_t y) const;
    void assemble(std::span<const Draft> drafts);

    bool smooth_;
    TexelPlaces places_;
    std::vector<Face> face_;  ///< of all regions' fronts, then of their backs if any has one
    std::vector<Node> node_;
    std::vector<std::uint16_t> number_;  ///< halves; where a block keeps its normal, that is the first two
    float unit_ = 1;                     ///< of the numbers of light, W/m^2
    double estimated_error_ = 0;
    std::array<std::size_t, block_kinds> blocks_{};

    friend class BlockMean;
};

static_assert(common::IrradianceEstimator<AdaptiveMap>);

}  // namespace shlm
