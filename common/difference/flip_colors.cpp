#include "common/difference/flip_colors.h"

namespace common {
namespace {

/// Returns CIE XYZ relative to that of white. The matrix is that of Rec. 709's primaries with white D65,
/// taken as (x, y) = (0.31271, 0.32902): each row sums to 1.
Vec3 relative_xyz(const Rgb& rgb) {
    return {0.4338953888f * rgb.x + 0.3762423726f * rgb.y + 0.1898622385f * rgb.z,
            0.2126368217f * rgb.x + 0.7151829818f * rgb.y + 0.0721801965f * rgb.z,
            0.0177524232f * rgb.x + 0.1094656287f * rgb.y + 0.8727819482f * rgb.z};
}

/// The inverse of relative_xyz.
Rgb linear_rgb(const Vec3& xyz) {
    return {3.0803419883f * xyz.x - 1.5373989695f * xyz.y - 0.5429430188f * xyz.z,
            -0.9211783962f * xyz.x + 1.8759299837f * xyz.y + 0.0452484125f * xyz.z,
            0.0528812929f * xyz.x - 0.2040112061f * xyz.y + 1.1511299132f * xyz.z};
}

/// The cube root of CIE L*a*b*, and its tangent line near black.
float lab_root(float t) {
    constexpr float delta = 6.0f / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29;
}

}  // namespace

OpponentColor opponent_color(const Rgb& linear) {
    const Vec3 xyz = relative_xyz(linear);
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

Rgb displayed_color(const OpponentColor& color) {
    const float y = (color.y + 16) / 116;
    const Rgb rgb = linear_rgb({y + color.cx / 500, y, y - color.cz / 200});
    return {std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f), std::clamp(rgb.z, 0.0f, 1.0f)};
}

HuntLab hunt_lab(const Rgb& linear) {
    const Vec3 xyz = relative_xyz(linear);
    const Vec3 root = {lab_root(xyz.x), lab_root(xyz.y), lab_root(xyz.z)};
    const float lightness = 116 * root.y - 16;
    const float scale = 0.01f * lightness;
    return {lightness, scale * 500 * (root.x - root.y), scale * 200 * (root.y - root.z)};
}

float hyab_distance(const HuntLab& p, const HuntLab& q) {
    const float a = p.a - q.a, b = p.b - q.b;
    return std::abs(p.lightness - q.lightness) + std::sqrt(a * a + b * b);
}

}  // namespace common
