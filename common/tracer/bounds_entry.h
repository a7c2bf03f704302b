// Where light from outside enters the box around a scene.
#pragma once

#include <Imath/ImathBox.h>

#include <array>

#include "common/core/vector.h"

namespace common {

/// Light that reaches the scene from outside enters its bounding box, which it shines through from no more
/// places than it must: a plain has the area of its top and no bounding sphere's.
class BoundsEntry {
  public:
    /// `bounds` must not be empty; it may be flat.
    explicit BoundsEntry(const Imath::Box3f& bounds);

    struct Place {
        Vec3 position;  ///< on the box
        Vec3 outward;   ///< unit, normal of the box's face
    };

    /// What the box covers of a plane perpendicular to `direction` (unit), square world units.
    [[nodiscard]] float area_across(const Vec3& direction) const;

    /// Where light along `direction` (unit) enters, uniform over what the box covers across it.
    [[nodiscard]] Place place_across(const Vec3& direction, float which_face, float u1, float u2) const;

    /// Of all six faces, square world units.
    [[nodiscard]] float area() const;

    /// Uniform over all six faces.
    [[nodiscard]] Place place(float which_face, float u1, float u2) const;

    /// More than from any place of the box to any other.
    [[nodiscard]] float reach() const { return size_.length(); }

  private:
    [[nodiscard]] Place place_on(int axis, bool at_max, float u1, float u2) const;

    Vec3 min_, size_;
    Vec3 face_area_;  ///< of one of the two faces perpendicular to each axis
};

}  // namespace common
