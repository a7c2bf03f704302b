#include "shlm/coverage_grid.h"

namespace shlm {
namespace {

using common::Vec2;

/// Twice the signed area of (a, b, p). In double, so that the sign is right for float coordinates.
double edge(const Vec2& a, const Vec2& b, double x, double y) {
    return (double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x);
}

}  // namespace

CoverageGrid::CoverageGrid(const Imath::Box2f& bounds, std::size_t triangle_count)
    : bounds_(bounds),
      size_(std::clamp(static_cast<int>(32 * std::sqrt(static_cast<double>(triangle_count))), 256, 512)),
      users_(static_cast<std::size_t>(size_) * size_, 0) {}

int CoverageGrid::cell_of(float value, int axis) const {
    const float position = (value - bounds_.min[axis]) / bounds_.size()[axis] * static_cast<float>(size_);
    return std::clamp(static_cast<int>(position), 0, size_ - 1);
}

template <class Visit>
void CoverageGrid::for_each_sample_in(const UvTriangle& triangle, Visit visit) const {
    const Vec2 &a = triangle[0], &b = triangle[1], &c = triangle[2];
    const auto first = [&](int axis) {
        return std::max(cell_of(std::min({a[axis], b[axis], c[axis]}), axis) - 1, 0);
    };
    const auto last = [&](int axis) {
        return std::min(cell_of(std::max({a[axis], b[axis], c[axis]}), axis) + 1, size_ - 1);
    };
    const double sign = edge(a, b, c.x, c.y) < 0 ? -1 : 1;
    for (int j = first(1); j <= last(1); ++j)
        for (int i = first(0); i <= last(0); ++i) {
            const double x = bounds_.min.x + (i + 0.5) / size_ * bounds_.size().x;
            const double y = bounds_.min.y + (j + 0.5) / size_ * bounds_.size().y;
            if (sign * edge(a, b, x, y) > 0 && sign * edge(b, c, x, y) > 0 && sign * edge(c, a, x, y) > 0)
                visit(static_cast<std::size_t>(j) * size_ + i);
        }
}

void CoverageGrid::add(const UvTriangle& triangle) {
    for_each_sample_in(triangle, [&](std::size_t sample) { users_[sample] = users_[sample] == 0 ? 1 : 2; });
}

double CoverageGrid::shared_part(const UvTriangle& triangle) const {
    std::size_t samples = 0, shared = 0;
    for_each_sample_in(triangle, [&](std::size_t sample) {
        ++samples;
        shared += users_[sample] > 1;
    });
    if (samples > 0) return static_cast<double>(shared) / static_cast<double>(samples);
    const Vec2 centroid = (triangle[0] + triangle[1] + triangle[2]) / 3;
    return users_[static_cast<std::size_t>(cell_of(centroid.y, 1)) * size_ + cell_of(centroid.x, 0)] > 1 ? 1
                                                                                                         : 0;
}

}  // namespace shlm
