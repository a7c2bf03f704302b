#include "shlm/layout/uv_overlaps.h"

#include <Imath/ImathBox.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shlm {
namespace {

using Imath::Box2f;
using Imath::V2d;

/// Corners counter-clockwise, in double.
using Corners = std::array<V2d, 3>;

double cross(const V2d& a, const V2d& b) {
    return a.x * b.y - a.y * b.x;
}

Corners counter_clockwise(const UvTriangle& t) {
    Corners corners = {V2d(t[0]), V2d(t[1]), V2d(t[2])};
    if (signed_double_area(t) < 0) std::swap(corners[1], corners[2]);
    return corners;
}

/// Returns the smallest distance from a corner to the opposite side.
double height(const Corners& t) {
    double longest_sq = 0;
    for (std::size_t i = 0; i < 3; ++i) longest_sq = std::max(longest_sq, (t[(i + 1) % 3] - t[i]).length2());
    return cross(t[1] - t[0], t[2] - t[0]) / std::sqrt(longest_sq);
}

/// Returns how far the triangles reach into each other across the sides of `a`; not positive if one of these
/// sides separates them.
double depth_behind_sides(const Corners& a, const Corners& b) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const V2d side = a[(i + 1) % 3] - a[i];
        double deepest = -std::numeric_limits<double>::infinity();
        for (const V2d& corner : b) deepest = std::max(deepest, cross(side, corner - a[i]));
        least = std::min(least, deepest / side.length());
    }
    return least;
}

/// Returns the area that both cover: `b` clipped by the sides of `a` (Sutherland and Hodgman 1974).
double common_area(const Corners& a, const Corners& b) {
    std::array<V2d, 8> polygon = {b[0], b[1], b[2]}, cut;
    std::size_t count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        const V2d side = a[(i + 1) % 3] - a[i];
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const V2d &p = polygon[k], &q = polygon[(k + 1) % count];
            const double inside_p = cross(side, p - a[i]), inside_q = cross(side, q - a[i]);
            if (inside_p >= 0) cut[kept++] = p;
            if ((inside_p > 0 && inside_q < 0) || (inside_p < 0 && inside_q > 0))
                cut[kept++] = p + (q - p) * (inside_p / (inside_p - inside_q));
        }
        polygon = cut;
        count = kept;
        if (count < 3) return 0;
    }
    double twice = 0;
    for (std::size_t k = 1; k + 1 < count; ++k)
        twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return twice / 2;
}

/// Two triangles that have so many overlaps each are not compared with each other.
constexpr std::size_t many_overlaps = 16;

/// Limit of the comparisons of a triangle in a cell that cannot be divided: if more meet there, many overlap.
constexpr std::size_t most_compared = 1024;

class Search {
  public:
    explicit Search(std::span<const UvTriangle> triangles)
        : corners_(triangles.size()), bounds_(triangles.size()), overlaps_of_(triangles.size(), 0) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            corners_[i] = counter_clockwise(triangles[i]);
            for (const common::Vec2& corner : triangles[i]) bounds_[i].extendBy(corner);
        }
    }

    std::vector<UvOverlap> run() {
        std::vector<std::uint32_t> all;
        Box2f bounds;
        for (std::uint32_t i = 0; i < corners_.size(); ++i) {
            if (!(height(corners_[i]) > 0)) continue;
            all.push_back(i);
            bounds.extendBy(bounds_[i]);
        }
        if (all.empty()) return {};
        const auto side = static_cast<double>(std::max(bounds.size().x, bounds.size().y));
        coarsest_tolerance_ = side / 16384;
        const common::Vec2 largest(std::max(std::abs(bounds.min.x), std::abs(bounds.max.x)),
                                   std::max(std::abs(bounds.min.y), std::abs(bounds.max.y)));
        rounding_ = 4 * static_cast<double>(std::max(largest.x, largest.y)) *
                    static_cast<double>(std::numeric_limits<float>::epsilon());
        divide(std::move(all), bounds);
        return std::move(overlaps_);
    }

  private:
    /// Compares all triangles that reach into `cell`, in smaller cells as long as these separate them.
    void divide(std::vector<std::uint32_t> inside, const Box2f& cell) {
        constexpr std::size_t few = 12;
        if (inside.size() > few) {
            const int axis = cell.size().x >= cell.size().y ? 0 : 1;
            const float middle = median(inside, axis);
            std::vector<std::uint32_t> lower, upper;
            for (const std::uint32_t i : inside) {
                if (bounds_[i].min[axis] <= middle) lower.push_back(i);
                if (bounds_[i].max[axis] > middle) upper.push_back(i);
            }
            // Divides only if few lie on both sides; otherwise there would be no progress.
            if (lower.size() + upper.size() <= inside.size() + inside.size() / 2 && middle > cell.min[axis] &&
                middle < cell.max[axis]) {
                inside = {};
                Box2f lower_cell = cell, upper_cell = cell;
                lower_cell.max[axis] = upper_cell.min[axis] = middle;
                divide(std::move(lower), lower_cell);
                divide(std::move(upper), upper_cell);
                return;
            }
        }
        compare_all(inside, cell);
    }

    float median(const std::vector<std::uint32_t>& inside, int axis) const {
        std::vector<float> centers;
        centers.reserve(inside.size());
        for (const std::uint32_t i : inside) centers.push_back(bounds_[i].center()[axis]);
        const auto middle = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
        std::nth_element(centers.begin(), middle, centers.end());
        return *middle;
    }

    void compare_all(std::vector<std::uint32_t>& inside, const Box2f& cell) {
        std::sort(inside.begin(), inside.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(bounds_[a].min.x, a) < std::pair(bounds_[b].min.x, b);
        });
        for (std::size_t i = 0; i < inside.size(); ++i) {
            const std::size_t end = std::min(inside.size(), i + most_compared);
            for (std::size_t k = i + 1; k < end && bounds_[inside[k]].min.x < bounds_[inside[i]].max.x; ++k)
                if (std::min(overlaps_of_[inside[i]], overlaps_of_[inside[k]]) < many_overlaps)
                    compare(std::min(inside[i], inside[k]), std::max(inside[i], inside[k]), cell);
        }
    }

    void compare(std::uint32_t a, std::uint32_t b, const Box2f& cell) {
        const Box2f &in_a = bounds_[a], &in_b = bounds_[b];
        const common::Vec2 low(std::max(in_a.min.x, in_b.min.x), std::max(in_a.min.y, in_b.min.y));
        if (low.x >= std::min(in_a.max.x, in_b.max.x) || low.y >= std::min(in_a.max.y, in_b.max.y)) return;
        // A pair in several cells belongs to the one that contains the low corner of the overlap of both
        // bounds.
        if (low.x < cell.min.x || low.y < cell.min.y || low.x > cell.max.x || low.y > cell.max.y) return;
        const Corners &of_a = corners_[a], &of_b = corners_[b];
        const double smaller = std::min(height(of_a), height(of_b));
        const double tolerance = std::max(rounding_, std::min(coarsest_tolerance_, smaller / 20));
        if (depth_behind_sides(of_a, of_b) <= tolerance || depth_behind_sides(of_b, of_a) <= tolerance)
            return;
        const double area = common_area(of_a, of_b);
        if (!(area > 0)) return;
        overlaps_.push_back({a, b, area});
        ++overlaps_of_[a];
        ++overlaps_of_[b];
    }

    std::vector<Corners> corners_;
    std::vector<Box2f> bounds_;
    std::vector<std::size_t> overlaps_of_;  ///< found so far
    std::vector<UvOverlap> overlaps_;
    double coarsest_tolerance_ = 0, rounding_ = 0;
};

}  // namespace

std::vector<UvOverlap> find_uv_overlaps(std::span<const UvTriangle> triangles) {
    std::vector<UvOverlap> overlaps = Search(triangles).run();
    const auto before = [](const UvOverlap& a, const UvOverlap& b) {
        return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    };
    std::sort(overlaps.begin(), overlaps.end(), before);
    // That corner may be on the border of two cells, so that a pair is found twice.
    overlaps.erase(std::unique(overlaps.begin(), overlaps.end(),
                               [](const UvOverlap& a, const UvOverlap& b) {
                                   return a.first == b.first && a.second == b.second;
                               }),
                   overlaps.end());
    return overlaps;
}

}  // namespace shlm
