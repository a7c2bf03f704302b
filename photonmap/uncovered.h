// Which photons lie on the near side of what covers the gather point.
#pragma once

#include <limits>

#include "common/tracer/covering_surfaces.h"

namespace photonmap {

/// Photons of a layer that covers the point, and of whatever is higher, are light that the layer kept from
/// it: they do not count. A photon that is no higher than the point always counts, and so does one that is
/// higher with nothing over the point, such as the next step's or that of a panel beside it: those stand for
/// photons that the point's own surface has not, where it ends or is in the shadow of the other.
///
/// What the photon's own surface is does not matter, so that soups of triangles and edges that do not match
/// answer as whole surfaces do.
class Uncovered {
  public:
    /// Where `covers` is null all photons are uncovered. Both must outlive it.
    Uncovered(const common::CoveringSurfaces* covers, const common::SurfacePoint& point)
        : covers_(covers),
          point_(&point),
          free_up_to_(covers ? covers->rounding() : std::numeric_limits<float>::infinity()) {}

    [[nodiscard]] bool operator()(const common::Vec3& photon) {
        const float height = (photon - point_->position).dot(point_->geometric_normal);
        if (!(height > free_up_to_)) return true;
        if (!covers_) return false;
        // Most gathers find nothing that is higher than their point: no ray is cast before one does.
        free_up_to_ = std::max(free_up_to_, covers_->height_over(*point_) - covers_->rounding());
        covers_ = nullptr;
        return !(height > free_up_to_);
    }

  private:
    const common::CoveringSurfaces* covers_;  ///< until it has been asked
    const common::SurfacePoint* point_;
    float free_up_to_;  ///< height over the point, world units
};

}  // namespace photonmap
