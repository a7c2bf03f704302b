#include "common/scene/triangle_overlap.h"

#include <Imath/ImathVec.h>

#include <algorithm>
#include <cstddef>

namespace common {
namespace {

using Imath::V3d;

/// A corner relative to a plane: x and y in the plane, z off it.
using OnPlane = V3d;
using PlaneTriangle = std::array<OnPlane, 3>;

/// Corners of a convex polygon, counter-clockwise: a triangle clipped by the three sides of another. It has
/// at most six, except for rounding.
struct Polygon {
    std::array<OnPlane, 9> corner;
    std::size_t count = 0;

    void add(const OnPlane& p) { corner[count++] = p; }
};

/// Returns how far `p` is on the inner (left) side of the line from `a` to `b`, which must differ.
double inside(const OnPlane& a, const OnPlane& b, const OnPlane& p) {
    const double x = b.x - a.x, y = b.y - a.y;
    return (x * (p.y - a.y) - y * (p.x - a.x)) / std::sqrt(x * x + y * y);
}

/// Both triangles projected to the plane of `flat`. Both become counter-clockwise.
struct Projection {
    PlaneTriangle flat, other;

    Projection(const TriangleCorners& flat_corners, const TriangleCorners& other_corners) {
        const V3d origin(flat_corners[0]);
        const V3d along = (V3d(flat_corners[1]) - origin).normalized();
        const V3d normal = along.cross(V3d(flat_corners[2]) - origin).normalized();
        const V3d across = normal.cross(along);
        for (std::size_t i = 0; i < 3; ++i) {
            const V3d f = V3d(flat_corners[i]) - origin, o = V3d(other_corners[i]) - origin;
            flat[i] = {along.dot(f), across.dot(f), 0};
            other[i] = {along.dot(o), across.dot(o), normal.dot(o)};
        }
        if (twice_area(other) < 0) std::swap(other[1], other[2]);
    }

    static double twice_area(const PlaneTriangle& t) {
        return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
    }
};

bool is_off_the_plane(const PlaneTriangle& t, double tolerance) {
    const auto [low, high] = std::minmax({t[0].z, t[1].z, t[2].z});
    return low > tolerance || high < -tolerance;
}

/// Returns whether all of `b` is outside one side of `a`, up to `tolerance`.
bool has_outside(const PlaneTriangle& a, const PlaneTriangle& b, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        const OnPlane &from = a[i], &to = a[(i + 1) % 3];
        if (inside(from, to, b[0]) <= tolerance && inside(from, to, b[1]) <= tolerance &&
            inside(from, to, b[2]) <= tolerance)
            return true;
    }
    return false;
}

/// Returns the part of the polygon on the inner side of the line from `a` to `b`.
Polygon cut(const Polygon& polygon, const OnPlane& a, const OnPlane& b) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const OnPlane &p = polygon.corner[i], &q = polygon.corner[(i + 1) % polygon.count];
        const double p_inside = inside(a, b, p), q_inside = inside(a, b, q);
        if (p_inside >= 0) kept.add(p);
        if ((p_inside >= 0) != (q_inside >= 0)) kept.add(p + (q - p) * (p_inside / (p_inside - q_inside)));
    }
    return kept;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.count; ++i)
        twice += Projection::twice_area({polygon.corner[0], polygon.corner[i - 1], polygon.corner[i]});
    return twice / 2;
}

}  // namespace

double narrowest_width(const TriangleCorners& triangle) {
    const V3d a(triangle[0]), b(triangle[1]), c(triangle[2]);
    const double longest_sq = std::max({(b - a).length2(), (c - b).length2(), (a - c).length2()});
    return longest_sq > 0 ? (b - a).cross(c - a).length() / std::sqrt(longest_sq) : 0;
}

double common_area(const TriangleCorners& a, const TriangleCorners& b, double tolerance) {
    const double a_width = narrowest_width(a), b_width = narrowest_width(b);
    if (std::min(a_width, b_width) <= tolerance) return 0;
    // Uses the plane of the wider triangle, as rounding tilts that of the narrower one more.
    const auto [flat, other] = a_width >= b_width ? Projection(a, b) : Projection(b, a);
    if (is_off_the_plane(other, tolerance)) return 0;
    if (Projection::twice_area(other) <= 0) return 0;  // it is perpendicular to the plane
    if (has_outside(flat, other, tolerance) || has_outside(other, flat, tolerance)) return 0;

    Polygon overlap;
    for (const OnPlane& p : other) overlap.add(p);
    for (std::size_t i = 0; i < 3; ++i) overlap = cut(overlap, flat[i], flat[(i + 1) % 3]);
    for (std::size_t i = 0; i < overlap.count; ++i)
        if (std::abs(overlap.corner[i].z) > tolerance) return 0;
    return area(overlap);
}

}  // namespace common
