// Vectors in structure-of-arrays layout, for loops that compilers vectorise.
#pragma once

#include <vector>

#include "common/core/vector.h"

namespace common {

/// A Vec3Array as plain pointers, to be held by value. A loop that reaches its arrays through an object must
/// reload their addresses after each store, and is not vectorised.
template <class Float>
struct Vec3View {
    Float *x, *y, *z;

    [[nodiscard]] Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }

    void set(std::size_t i, const Vec3& value) const {
        x[i] = value.x;
        y[i] = value.y;
        z[i] = value.z;
    }
};

struct Vec3Array {
    std::vector<float> x, y, z;

    /// The values of new elements are undefined.
    void resize(std::size_t count) {
        x.resize(count);
        y.resize(count);
        z.resize(count);
    }

    [[nodiscard]] Vec3View<float> view() { return {x.data(), y.data(), z.data()}; }
    [[nodiscard]] Vec3View<const float> view() const { return {x.data(), y.data(), z.data()}; }

    [[nodiscard]] Vec3 operator[](std::size_t i) const { return view()[i]; }
    void set(std::size_t i, const Vec3& value) { view().set(i, value); }
};

}  // namespace common
