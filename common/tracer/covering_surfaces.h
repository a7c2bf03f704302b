// Finds what lies over a point of a surface.
#pragma once

#include "common/scene/surface_pieces.h"
#include "common/tracer/ray_scene.h"

namespace common {

/// Finds surfaces of a scene that lie over others: a shelf over the one below, a panel over its wall.
class CoveringSurfaces {
  public:
    /// `rays` and its scene must outlive this object.
    explicit CoveringSurfaces(const RayScene& rays) : CoveringSurfaces(rays, SurfacePieces(rays.scene())) {}

    /// Does the same with the scene's pieces, if they are known.
    CoveringSurfaces(const RayScene& rays, SurfacePieces pieces) : rays_(&rays), pieces_(std::move(pieces)) {}

    /// Returns the height of the nearest surface over the point, along its geometric normal, world units;
    /// infinite if there is none. It is infinite too if the nearest surface belongs to the point's own piece
    /// (SurfacePieces): a surface that bends over itself does not cover itself.
    [[nodiscard]] float height_over(const SurfacePoint& point) const;

    /// Returns the rounding error of heights, world units.
    [[nodiscard]] float rounding() const { return rays_->surface_offset(); }

    /// Returns the memory without the scene and its rays.
    [[nodiscard]] std::size_t bytes() const { return pieces_.bytes(); }

  private:
    const RayScene* rays_;
    SurfacePieces pieces_;
};

}  // namespace common
