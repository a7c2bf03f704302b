// The parts of a scene's light map that do not depend on its light.
#pragma once

#include <memory>
#include <mutex>

#include "shlm/layout/normals_in_use.h"
#include "shlm/layout/texel_charts.h"
#include "shlm/layout/texel_geometry.h"
#include "shlm/layout/texel_pieces.h"
#include "shlm/layout/texel_tree.h"

namespace shlm {

/// Made once, used by any number of runs.
struct PreparedTexels {
    TexelLayout layout;
    std::vector<TexelGeometry> geometry;        ///< one per texel of the layout
    std::vector<NormalsInUse> normals;          ///< one per region of the layout
    std::shared_ptr<const TexelPieces> pieces;  ///< shared by all maps that need a point's own surface

    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels,
                   TexelPlacement placement = TexelPlacement::uv)
        : PreparedTexels(scene, uv, texels, placement, common::SurfacePieces(scene)) {}

    /// Does the same with the scene's pieces, if they are known.
    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels,
                   TexelPlacement placement, common::SurfacePieces of_surface)
        : layout(scene, texel_charts(scene, uv, placement, texels), texels),
          geometry(texel_geometry(scene, layout, of_surface)),
          normals(normals_in_use(scene, layout)),
          pieces(std::make_shared<TexelPieces>(std::move(of_surface), layout, geometry)) {}

    /// Returns the tree, made at the first call, as not every gather needs it. May be called from any thread.
    [[nodiscard]] const std::shared_ptr<const TexelTree>& tree() const {
        std::call_once(tree_->once, [this] { tree_->made = std::make_shared<TexelTree>(geometry); });
        return tree_->made;
    }

    /// Returns the memory without the tree, which is part of the maps that use it.
    [[nodiscard]] std::size_t bytes() const {
        std::size_t bytes = layout.bytes() + geometry.capacity() * sizeof(TexelGeometry) + pieces->bytes() +
                            normals.capacity() * sizeof(NormalsInUse);
        for (const NormalsInUse& of_region : normals)
            bytes += of_region.bent.capacity() * sizeof(common::Vec3);
        return bytes;
    }

  private:
    struct Tree {
        std::once_flag once;
        std::shared_ptr<const TexelTree> made;
    };

    std::shared_ptr<Tree> tree_ = std::make_shared<Tree>();
};

}  // namespace shlm
