// A light map of blocks: each as large as its light allows, with no more numbers than its light needs.
#pragma once

#include "common/estimator/irradiance_estimator.h"
#include "shlm/adaptive/block_search.h"
#include "shlm/layout/texel_places.h"
#include "shlm/map/gather.h"

namespace shlm {

/// Immutable. Made from the sums of a light map whose texels are its smallest blocks. So hits take constant
/// time and memory, and the structure of the map is decided only when it is finished. It needs nothing else
/// afterwards.
class AdaptiveMap {
  public:
    /// Builds `search.smallest(wanted_error)`. `layout` is that of the sums that were searched. If `smooth`,
    /// neighbouring blocks blend as in Bilinear, over the width of the smaller; otherwise each block has one
    /// light. Throws InputError if there are more blocks than can be counted.
    AdaptiveMap(const BlockSearch& search, const TexelLayout& layout, double wanted_error, bool smooth);

    /// Returns irradiance for the shading normal, W/m^2. Never negative; zero if no block contributes.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const;

    [[nodiscard]] std::size_t bytes() const;

    /// Returns the relative root mean square error over the scene's surface, each part for the shading
    /// normals that its material has: sqrt(mean of (error)^2 / (irradiance^2 + epsilon)), epsilon = 0.01
    /// (mean irradiance)^2. It is estimated for constant blocks; smooth ones have less.
    [[nodiscard]] double estimated_error() const { return estimated_error_; }

    /// The block that gives a point its light if the map is not smooth; nothing if no block contributes.
    struct BlockAt {
        BlockKind kind;
        std::uint32_t width;  ///< texels a side
    };
    [[nodiscard]] std::optional<BlockAt> block_at(const common::SurfacePoint& point) const;

    /// What the map shows at one place, for all normals.
    struct FaceLight {
        common::Vec3 normal;    ///< of the block that the place lies in
        TexelLight<2> moments;  ///< W/m^2, as HemisphereFit<2> keeps them: each block as its moments_of
    };

    /// Returns the light at a place, whatever the normals of its triangles; nothing if its block has no
    /// surface.
    [[nodiscard]] std::optional<FaceLight> light_at(const TexelPlace& place) const;

    /// Returns the width of the smallest block with a surface on a region's faces, texels; 0 if it has none.
    [[nodiscard]] std::uint32_t finest_block(std::uint32_t region) const;

    /// Returns the number of blocks of each kind.
    [[nodiscard]] const std::array<std::size_t, block_kinds>& blocks() const { return blocks_; }

  private:
    /// The index of up to 4 consecutive nodes, those of a divided block. For a block: bit 31, three bits of
    /// kind, and the index of its first number.
    using Node = std::uint32_t;

    struct Face {
        Node root = 0;
        /// Packed, for all its blocks. The default, to which no normal is packed, means that blocks keep
        /// their own.
        std::array<std::uint16_t, 2> normal{0xffff, 0xffff};

        [[nodiscard]] bool has_one_normal() const { return normal[0] != 0xffff; }
    };

    struct Found {
        Node node;
        std::uint32_t x, y, size;  ///< in texels of the region
    };

    /// A block as it is stored.
    struct StoredBlock {
        BlockKind kind;
        common::Vec3 normal{0, 0, 0};  ///< zero if it is uncovered
        const std::uint16_t* number = nullptr;

        /// Returns the numbers that a basis keeps; those of light are in the map's unit.
        template <Basis B>
        [[nodiscard]] typename B::Numbers numbers() const;
    };

    struct Draft;
    class Drawing;

    [[nodiscard]] std::size_t face_index(std::uint32_t region, bool back) const {
        return region + (back ? places_.region_count() : 0);
    }
    [[nodiscard]] Found find(const Face& face, const TexelRegion& region, std::uint32_t x,
                             std::uint32_t y) const;
    /// Returns the block that a place lies in.
    [[nodiscard]] Found find(const Face& face, const TexelPlace& place) const {
        const TexelRegion& region = places_.region(place);
        return find(face, region, place.column(region), place.row(region));
    }
    [[nodiscard]] StoredBlock block_of(const Face& face, Node node) const;

    /// Calls `use(node, weight)` for the block at a place and, if the map is smooth, for those that blend
    /// with it there. The weights add up to 1 unless there is no block beyond a border.
    template <class Use>
    void for_blocks(const Face& face, const TexelPlace& place, Use use) const;

    void assemble(std::span<const Draft> drafts);

    bool smooth_;
    TexelPlaces places_;
    std::vector<Face> face_;  ///< the fronts of all regions, then their backs if any region has one
    std::vector<Node> node_;
    std::vector<std::uint16_t> number_;  ///< halves; if a block keeps its normal, its first two
    float unit_ = 1;                     ///< of the coefficients of light, W/m^2
    double estimated_error_ = 0;
    std::array<std::size_t, block_kinds> blocks_{};
};

static_assert(common::IrradianceEstimator<AdaptiveMap>);

}  // namespace shlm
