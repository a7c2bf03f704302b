#include "common/reference/direction_choice.h"

#include <numbers>

#include "common/reference/directions.h"

namespace common::reference {
namespace {

using Imath::V3d;
using std::numbers::pi;

constexpr double aimed_share = 0.5;

/// The cone that a sphere subtends.
struct Cone {
    V3d axis;              ///< unit
    double one_minus_cos;  ///< of its half angle; 0 where the point lies in the sphere

    Cone(const SpecularBounds& bounds, const V3d& from) {
        const V3d joining = bounds.center - from;
        const double distance_sq = joining.length2(), radius_sq = bounds.radius * bounds.radius;
        axis = joining / std::sqrt(distance_sq);
        one_minus_cos = distance_sq > radius_sq ? 1 - std::sqrt(1 - radius_sq / distance_sq) : 0;
    }
};

double cosine_density(const Receiver& receiver, const Vec3& towards) {
    return std::max(0.0, V3d(receiver.normal).dot(V3d(towards))) / pi;
}

/// Returns a direction uniform over the cone (Archimedes: area on the sphere is proportional to height).
Vec3 direction_in(const Cone& cone, const std::array<double, 2>& square) {
    const double z = 1 - square[0] * cone.one_minus_cos, r = std::sqrt(std::max(0.0, 1 - z * z));
    const Tangents tangents(cone.axis);
    const double turn = 2 * pi * square[1];
    return Vec3(
        (tangents.first * (r * std::cos(turn)) + tangents.second * (r * std::sin(turn)) + cone.axis * z)
            .normalized());
}

}  // namespace

std::vector<SpecularBounds> specular_bounds(const Scene& scene) {
    std::vector<SpecularBounds> all;
    for (const MeshInstance& instance : scene.instance) {
        if (scene.material[instance.material].kind == SurfaceKind::diffuse) continue;
        Imath::Box3d box;
        for (std::uint32_t t = 0; t < instance.triangle_count; ++t)
            for (const std::uint32_t vertex : scene.triangle[instance.first_triangle + t])
                box.extendBy(V3d(scene.position[vertex]));
        if (!box.isEmpty()) all.push_back({box.center(), 0.5 * box.size().length()});
    }
    return all;
}

Vec3 DirectionChoice::choose(const std::array<double, 2>& square) const {
    if (bounds_.empty()) return cosine_direction(receiver_.normal, square);
    if (square[0] >= aimed_share)
        return cosine_direction(receiver_.normal, {(square[0] - aimed_share) / (1 - aimed_share), square[1]});
    // The first number also chooses the object; its remainder is again uniform.
    const double scaled = square[0] / aimed_share * static_cast<double>(bounds_.size());
    const std::size_t chosen = std::min(static_cast<std::size_t>(scaled), bounds_.size() - 1);
    const std::array<double, 2> rest = {scaled - static_cast<double>(chosen), square[1]};
    const Cone cone(bounds_[chosen], V3d(receiver_.origin));
    return cone.one_minus_cos > 0 ? direction_in(cone, rest) : cosine_direction(receiver_.normal, rest);
}

double DirectionChoice::density(const Vec3& towards) const {
    const double by_cosine = cosine_density(receiver_, towards);
    if (bounds_.empty()) return by_cosine;
    const V3d unit = V3d(towards).normalized();  // in float, a small cone would miss its own directions
    double aimed = 0;
    for (const SpecularBounds& bounds : bounds_) {
        const Cone cone(bounds, V3d(receiver_.origin));
        if (cone.one_minus_cos == 0)
            aimed += by_cosine;
        else if (1 - cone.axis.dot(unit) < cone.one_minus_cos)
            aimed += 1 / (2 * pi * cone.one_minus_cos);
    }
    return (1 - aimed_share) * by_cosine + aimed_share * aimed / static_cast<double>(bounds_.size());
}

}  // namespace common::reference
