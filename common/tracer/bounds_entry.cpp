#include "common/tracer/bounds_entry.h"

#include <cmath>

namespace common {
namespace {

/// Chooses an axis in proportion to its weight, and rescales `number` to be uniform again.
int choose_axis(const Vec3& weight, float& number) {
    float place = number * (weight.x + weight.y + weight.z);
    int axis = 0;
    // Rounding must not choose a face without area.
    while (axis < 2 && (place >= weight[axis] || weight[axis] == 0)) place -= weight[axis++];
    while (axis > 0 && weight[axis] == 0) --axis;
    number = weight[axis] > 0 ? std::clamp(place / weight[axis], 0.0f, 1.0f) : 0.0f;
    return axis;
}

}  // namespace

BoundsEntry::BoundsEntry(const Imath::Box3f& bounds)
    : min_(bounds.min),
      size_(bounds.max - bounds.min),
      face_area_(size_.y * size_.z, size_.z * size_.x, size_.x * size_.y) {}

float BoundsEntry::area_across(const Vec3& direction) const {
    return face_area_.x * std::abs(direction.x) + face_area_.y * std::abs(direction.y) +
           face_area_.z * std::abs(direction.z);
}

BoundsEntry::Place BoundsEntry::place_across(const Vec3& direction, float which_face, float u1,
                                             float u2) const {
    const Vec3 covered(face_area_.x * std::abs(direction.x), face_area_.y * std::abs(direction.y),
                       face_area_.z * std::abs(direction.z));
    const int axis = choose_axis(covered, which_face);
    return place_on(axis, direction[axis] < 0, u1, u2);
}

float BoundsEntry::area() const {
    return 2 * (face_area_.x + face_area_.y + face_area_.z);
}

BoundsEntry::Place BoundsEntry::place(float which_face, float u1, float u2) const {
    const int axis = choose_axis(face_area_, which_face);
    return place_on(axis, which_face >= 0.5f, u1, u2);
}

BoundsEntry::Place BoundsEntry::place_on(int axis, bool at_max, float u1, float u2) const {
    Vec3 within(0, 0, 0), outward(0, 0, 0);
    within[axis] = at_max ? 1.0f : 0.0f;
    within[(axis + 1) % 3] = u1;
    within[(axis + 2) % 3] = u2;
    outward[axis] = at_max ? 1.0f : -1.0f;
    return {min_ + size_ * within, outward};
}

}  // namespace common
