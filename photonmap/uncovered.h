// Selects the photons that no surface over the gather point separates from it.
#pragma once

#include <limits>

#include "common/tracer/covering_surfaces.h"

namespace photonmap {

/// Photons on a layer that covers the point, or higher, are light that the layer kept from the point, so they
/// do not count. A photon that is no higher than the point always counts. So does a higher one if nothing is
/// over the point, such as one on the next step or on a panel beside it. It stands for photons that the
/// point's own surface lacks, where that surface ends or is in the other's shadow.
///
/// The photon's own surface does not matter, so that triangle soups and edges that do not match give the same
/// result as whole surfaces.
class Uncovered {
  public:
    /// If `covers` is null, all photons are uncovered. Both must outlive this object.
    Uncovered(const common::CoveringSurfaces* covers, const common::SurfacePoint& point)
        : covers_(covers),
          point_(&point),
          free_up_to_(covers ? covers->rounding() : std::numeric_limits<float>::infinity()) {}

    [[nodiscard]] bool operator()(const common::Vec3& photon) {
        const float height = (photon - point_->position).dot(point_->geometric_normal);
        if (!(height > free_up_to_)) return true;
        if (!covers_) return false;
        // Most gathers find no photon higher than their point, so the ray is cast only once there is one.
        free_up_to_ = std::max(free_up_to_, covers_->height_over(*point_) - covers_->rounding());
        covers_ = nullptr;
        return !(height > free_up_to_);
    }

  private:
    const common::CoveringSurfaces* covers_;  ///< null after it has been queried
    const common::SurfacePoint* point_;
    float free_up_to_;  ///< height over the point, world units
};

}  // namespace photonmap
