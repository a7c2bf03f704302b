// Everything about a scene's light map that does not depend on its light.
#pragma once

#include <memory>

#include "shlm/layout/normals_in_use.h"
#include "shlm/layout/texel_charts.h"
#include "shlm/layout/texel_geometry.h"
#include "shlm/layout/texel_pieces.h"

namespace shlm {

/// Made once, used by any number of runs.
struct PreparedTexels {
    TexelLayout layout;
    std::vector<TexelGeometry> geometry;        ///< one per texel of the layout
    std::vector<NormalsInUse> normals;          ///< one per region of the layout
    std::shared_ptr<const TexelPieces> pieces;  ///< all maps that look a point's own surface up share them

    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels,
                   TexelPlacement placement = TexelPlacement::uv)
        : PreparedTexels(scene, uv, texels, placement, common::SurfacePieces(scene)) {}

    [[nodiscard]] std::size_t bytes() const {
        std::size_t bytes = layout.bytes() + geometry.capacity() * sizeof(TexelGeometry) + pieces->bytes() +
                            normals.capacity() * sizeof(NormalsInUse);
        for (const NormalsInUse& of_region : normals)
            bytes += of_region.bent.capacity() * sizeof(common::Vec3);
        return bytes;
    }

  private:
    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels,
                   TexelPlacement placement, common::SurfacePieces of_surface)
        : layout(scene, texel_charts(scene, uv, placement, texels), texels),
          geometry(texel_geometry(scene, layout, of_surface)),
          normals(normals_in_use(scene, layout)),
          pieces(std::make_shared<TexelPieces>(std::move(of_surface), layout, geometry)) {}
};

}  // namespace shlm
