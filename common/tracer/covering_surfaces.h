// What lies over a point of a surface.
#pragma once

#include "common/scene/surface_pieces.h"
#include "common/tracer/ray_scene.h"

namespace common {

/// Surfaces of a scene as they lie over each other: a shelf over the one below, a panel over its wall.
class CoveringSurfaces {
  public:
    /// `rays` and its scene must outlive it.
    explicit CoveringSurfaces(const RayScene& rays) : CoveringSurfaces(rays, SurfacePieces(rays.scene())) {}

    /// The same with the scene's pieces, where they are known.
    CoveringSurfaces(const RayScene& rays, SurfacePieces pieces) : rays_(&rays), pieces_(std::move(pieces)) {}

    /// How high over the point, along its geometric normal, the nearest surface is, world units; infinite
    /// where there is none. A surface that bends over itself does not cover itself: what is nearest and of
    /// the point's own piece (SurfacePieces) counts as none.
    [[nodiscard]] float height_over(const SurfacePoint& point) const;

    /// Heights are known no better than that, world units.
    [[nodiscard]] float rounding() const { return rays_->surface_offset(); }

    /// Without the scene and its rays.
    [[nodiscard]] std::size_t bytes() const { return pieces_.bytes(); }

  private:
    const RayScene* rays_;
    SurfacePieces pieces_;
};

}  // namespace common
