// The surface under a block of texels, and whether it is a single one.
#pragma once

#include <Imath/ImathVec.h>

#include <span>

#include "shlm/layout/texel_geometry.h"

namespace shlm {

/// Sums over the texels of a block.
struct BlockSurface {
    double area = 0;             ///< covered, world units squared
    Imath::V3d normal{0, 0, 0};  ///< times area
    Imath::V3d center{0, 0, 0};  ///< times area
    bool one = true;             ///< nearly flat and connected

    [[nodiscard]] static BlockSurface of_texel(const TexelGeometry& texel) {
        if (texel.area == 0) return {};
        return {texel.area, Imath::V3d(texel.normal) * texel.area, Imath::V3d(texel.center) * texel.area};
    }

    [[nodiscard]] common::Vec3 unit_normal() const {
        return area > 0 ? common::Vec3(normal.normalized()) : common::Vec3(0, 0, 1);
    }
};

/// Returns the surface of the block that consists of these parts, `width` world units wide. It is one surface
/// if all parts are, none faces away from their mean by more than 25 degrees, and none is farther from it
/// than the block is wide.
[[nodiscard]] inline BlockSurface joined(std::span<const BlockSurface> parts, double width) {
    constexpr double same_block_cosine = 0.9;
    BlockSurface block;
    for (const BlockSurface& part : parts) {
        block.area += part.area;
        block.normal += part.normal;
        block.center += part.center;
    }
    for (const BlockSurface& part : parts) {
        if (part.area == 0) continue;
        const double cosine = part.normal.dot(block.normal) / (part.normal.length() * block.normal.length());
        const double apart = (part.center / part.area - block.center / block.area).length();
        block.one = block.one && part.one && cosine >= same_block_cosine && apart <= width;
    }
    return block;
}

}  // namespace shlm
