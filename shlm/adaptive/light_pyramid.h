// One face of a region with all its blocks: squares of 1, 2, 4, 8 ... texels a side.
#pragma once

#include <vector>

#include "shlm/adaptive/block_kind.h"
#include "shlm/layout/block_surface.h"
#include "shlm/layout/prepared_texels.h"
#include "shlm/sums/texel_sums.h"

namespace shlm {

/// The sums that an adaptive map is made from: the harmonics, and the surface's exact irradiance.
using AdaptiveModel = TexelModel<2, ShWeight::normalised>;

struct LightBlock {
    BlockSurface surface;
    double hits = 0;
    std::array<float, 3 * AdaptiveModel::summed> watts{};  ///< as TexelSum::value

    [[nodiscard]] BlockLight light() const;
};

/// A face of a region.
struct RegionFace {
    std::uint32_t region;
    bool back;
};

class LightPyramid {
  public:
    LightPyramid() = default;  ///< without levels
    LightPyramid(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels, float watts_per_flux,
                 const RegionFace& face);

    [[nodiscard]] const RegionFace& face() const { return face_; }

    /// Returns whether all texels' normals are within a degree of their mean.
    [[nodiscard]] bool is_flat() const { return is_flat_; }

    /// Level 0 has a block for each texel, the last level has one.
    [[nodiscard]] std::size_t levels() const { return level_.size(); }
    [[nodiscard]] std::uint32_t width(std::size_t level) const { return level_[level].width; }
    [[nodiscard]] std::uint32_t height(std::size_t level) const { return level_[level].height; }

    /// Returns the block that covers the whole face.
    [[nodiscard]] const LightBlock& largest_block() const { return level_.back().block.front(); }

    [[nodiscard]] const LightBlock& block(std::size_t level, std::uint32_t x, std::uint32_t y) const {
        return level_[level].block[std::size_t{y} * level_[level].width + x];
    }

    /// The number of blocks of all levels, and the index of one of them: level by level, row by row.
    [[nodiscard]] std::size_t block_count() const { return level_.back().first + level_.back().block.size(); }
    [[nodiscard]] std::size_t index(std::size_t level, std::uint32_t x, std::uint32_t y) const {
        return level_[level].first + std::size_t{y} * level_[level].width + x;
    }

    /// Calls `use(child x, child y)` for the up to four blocks of the level below.
    template <class Use>
    void for_children(std::size_t level, std::uint32_t x, std::uint32_t y, Use use) const {
        const Level& below = level_[level - 1];
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t child_x = 2 * x + i % 2, child_y = 2 * y + i / 2;
            if (child_x < below.width && child_y < below.height) use(child_x, child_y);
        }
    }

  private:
    struct Level {
        std::uint32_t width, height;
        std::size_t first;              ///< index of its first block
        std::vector<LightBlock> block;  ///< row by row
    };

    void join(std::size_t level, double width_of_texel);

    [[nodiscard]] bool has_one_normal() const;

    RegionFace face_{};
    bool is_flat_ = false;
    std::vector<Level> level_;
};

/// Returns one pyramid for each face of the layout.
[[nodiscard]] std::vector<LightPyramid> light_pyramids(const TexelSums<AdaptiveModel>& sums,
                                                       const PreparedTexels& texels, float watts_per_flux);

}  // namespace shlm
