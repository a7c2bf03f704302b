#include "common/reference/specular.h"

#include <array>

namespace common::reference {
namespace {

using Imath::V3d;

/// A specular surface at one point, as seen from the side that light leaves to.
struct Boundary {
    V3d leaving;
    V3d normal;  ///< geometric, on the leaving side
    V3d smooth;  ///< vertex normal, on the leaving side
    SurfaceKind kind;
    double index_ratio;  ///< index of the other side over that of the leaving side; of a sheet, its index
};

struct Candidate {
    V3d towards{0, 0, 0};
    bool across = false;  ///< arrives from the other side
    double flux = 0;      ///< factor of radiance without squared indices; weight for choosing it
};

V3d mirrored(const V3d& v, const V3d& axis) {
    return axis * (2 * v.dot(axis)) - v;
}

/// Returns the refracted direction on the other side of a boundary for `v`, which points away from it, into
/// the half space of `axis`; nothing beyond the critical angle. `index_ratio`: the other side over this one.
std::optional<V3d> bent(const V3d& v, const V3d& axis, double index_ratio) {
    const V3d tangential = (axis * v.dot(axis) - v) * (1 / index_ratio);
    const double left = 1 - tangential.length2();
    if (left <= 0) return std::nullopt;
    return (tangential - axis * std::sqrt(left)).normalized();
}

/// Returns the fraction of light from `towards`, on the side of `normal`, that is reflected; it is deflected
/// about `axis`.
double kept(const Boundary& b, const V3d& towards, const V3d& normal, const V3d& axis, double index_ratio) {
    if (b.kind == SurfaceKind::thin_sheet) return reflected_by_sheet(towards.dot(axis), b.index_ratio);
    if (b.kind != SurfaceKind::dielectric) return 1;
    const std::optional<V3d> through = bent(towards, axis, index_ratio);
    if (!through || through->dot(normal) >= 0) return 1;
    return reflected_fraction(towards.dot(axis), index_ratio);
}

// The ways in which light leaves along one direction: reflected or transmitted about the smooth normal, the
// same about the geometric normal where the smooth one sends it to the wrong side, or straight through a thin
// sheet.

Candidate reflected_about_smooth(const Boundary& b) {
    const V3d towards = mirrored(b.leaving, b.smooth);
    if (towards.dot(b.smooth) <= 0 || towards.dot(b.normal) <= 0) return {};
    return {towards, false,
            kept(b, towards, b.normal, b.smooth, b.index_ratio) * towards.dot(b.normal) /
                b.leaving.dot(b.normal)};
}

Candidate reflected_about_normal(const Boundary& b) {
    const V3d towards = mirrored(b.leaving, b.normal);
    const bool facing = towards.dot(b.smooth) > 0;
    if (facing && mirrored(towards, b.smooth).dot(b.normal) > 0) return {};
    return {towards, false, kept(b, towards, b.normal, facing ? b.smooth : b.normal, b.index_ratio)};
}

Candidate transmitted_about(const Boundary& b, const V3d& axis) {
    if (b.leaving.dot(axis) <= 0) return {};
    const std::optional<V3d> towards = bent(b.leaving, axis, b.index_ratio);
    if (!towards || towards->dot(b.normal) >= 0) return {};
    const double passed = 1 - kept(b, *towards, -b.normal, -axis, 1 / b.index_ratio);
    const double cosines =
        towards->dot(b.normal) * b.leaving.dot(axis) / (b.leaving.dot(b.normal) * towards->dot(axis));
    return {*towards, true, passed * cosines};
}

Candidate transmitted_about_smooth(const Boundary& b) {
    return transmitted_about(b, b.smooth);
}

Candidate transmitted_about_normal(const Boundary& b) {
    const Candidate candidate = transmitted_about(b, b.normal);
    return candidate.towards.dot(b.smooth) < 0 ? Candidate{} : candidate;
}

/// Straight through a thin sheet. Its reflectance uses the smooth normal, unless that faces away.
Candidate unbent(const Boundary& b) {
    const V3d& axis = b.leaving.dot(b.smooth) > 0 ? b.smooth : b.normal;
    return {-b.leaving, true, 1 - reflected_by_sheet(b.leaving.dot(axis), b.index_ratio)};
}

Boundary boundary_at(const Scene& scene, const SurfaceId& surface, const Vec3& leaving) {
    const Material& material = scene.material_of(surface.triangle);
    const V3d front(scene.geometric_normal[surface.triangle]);
    const double side = front.dot(V3d(leaving)) > 0 ? 1 : -1;
    const double index = static_cast<double>(material.index_of_refraction);
    const bool from_outside = material.kind == SurfaceKind::thin_sheet || side > 0;
    return {V3d(leaving), front * side, V3d(smooth_normal_at(scene, surface)) * side, material.kind,
            from_outside ? index : 1 / index};
}

}  // namespace

double reflected_fraction(double cosine, double index_ratio) {
    const double g_sq = index_ratio * index_ratio - 1 + cosine * cosine;
    if (g_sq <= 0) return 1;
    const double g = std::sqrt(g_sq);
    const double a = (g - cosine) / (g + cosine);
    const double b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return 0.5 * a * a * (1 + b * b);
}

double reflected_by_sheet(double cosine, double index) {
    // The sheet transmits (1 - R)^2 (1 + R^2 + R^4 + ...): two boundaries, and two more reflections per way
    // back.
    const double once = reflected_fraction(cosine, index);
    return 1 - (1 - once) / (1 + once);
}

double passed_straight(const Scene& scene, const SurfaceId& surface, const Vec3& leaving) {
    const Boundary b = boundary_at(scene, surface, leaving);
    if (b.kind != SurfaceKind::thin_sheet || b.leaving.dot(b.normal) <= 0) return 0;
    return unbent(b).flux;
}

std::optional<SpecularArrival> specular_arrival(const Scene& scene, const SurfaceId& surface,
                                                const Vec3& leaving, double uniform) {
    const Boundary b = boundary_at(scene, surface, leaving);
    if (b.leaving.dot(b.normal) <= 0) return std::nullopt;
    std::array<Candidate, 4> candidates = {reflected_about_smooth(b), reflected_about_normal(b), {}, {}};
    if (b.kind == SurfaceKind::dielectric) {
        candidates[2] = transmitted_about_smooth(b);
        candidates[3] = transmitted_about_normal(b);
    }
    const bool sheet = b.kind == SurfaceKind::thin_sheet;
    if (sheet) candidates[2] = unbent(b);
    double total = 0;
    for (const Candidate& candidate : candidates) total += candidate.flux;
    double left = uniform * total;
    for (const Candidate& candidate : candidates) {
        left -= candidate.flux;
        if (candidate.flux <= 0 || left > 0) continue;
        const double indices = candidate.across && !sheet ? 1 / (b.index_ratio * b.index_ratio) : 1;
        return SpecularArrival{Vec3(candidate.towards), Vec3(candidate.across ? -b.normal : b.normal),
                               total * indices, indices, candidate.across && sheet};
    }
    return std::nullopt;
}

}  // namespace common::reference
