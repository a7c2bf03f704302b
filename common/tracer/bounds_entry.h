// Samples where light from outside enters the box around a scene.
#pragma once

#include <Imath/ImathBox.h>

#include <array>

#include "common/core/vector.h"

namespace common {

/// Samples where light from outside enters the scene's bounding box. A box exposes less area than a bounding
/// sphere: for a flat scene only that of its top.
class BoundsEntry {
  public:
    /// `bounds` must not be empty; it may be flat.
    explicit BoundsEntry(const Imath::Box3f& bounds);

    struct Place {
        Vec3 position;  ///< on the box
        Vec3 outward;   ///< unit, normal of the box's face
    };

    /// Returns the area of the box projected along `direction` (unit), square world units.
    [[nodiscard]] float area_across(const Vec3& direction) const;

    /// Returns where light along `direction` (unit) enters, uniform over the projected area.
    [[nodiscard]] Place place_across(const Vec3& direction, float which_face, float u1, float u2) const;

    /// Returns the area of all six faces, square world units.
    [[nodiscard]] float area() const;

    /// Returns a place, uniform over all six faces.
    [[nodiscard]] Place place(float which_face, float u1, float u2) const;

    /// Returns a length greater than any distance within the box.
    [[nodiscard]] float reach() const { return size_.length(); }

  private:
    [[nodiscard]] Place place_on(int axis, bool at_max, float u1, float u2) const;

    Vec3 min_, size_;
    Vec3 face_area_;  ///< of one of the two faces perpendicular to each axis
};

}  // namespace common
