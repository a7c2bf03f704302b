// The clamped cosine as the harmonics approximate it over the hemisphere that light can come from.
#pragma once

#include <cmath>
#include <numbers>

#include "common/core/vector.h"
#include "shlm/basis/sh_basis.h"

namespace shlm {

/// A polynomial of a unit direction w: constant + linear . w + w^T S w, with a symmetric S of trace 0.
struct DirectionPolynomial {
    float constant = 0;
    common::Vec3 linear{0, 0, 0};
    float xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, xz = 0;  ///< of S

    /// Returns the factors of the orthonormal harmonics that add up to the same function.
    template <int Order>
    requires(Order == 1 || Order == 2) [[nodiscard]] ShValues<Order> harmonics() const {
        using namespace sh_constants;
        ShValues<Order> factors;
        factors[0] = constant / c0;
        factors[1] = linear.y / c1;
        factors[2] = linear.z / c1;
        factors[3] = linear.x / c1;
        if constexpr (Order == 2) {
            factors[4] = 2 * xy / c2;
            factors[5] = 2 * yz / c2;
            factors[6] = zz / (2 * c20);
            factors[7] = 2 * xz / c2;
            factors[8] = (xx - yy) / (2 * c22);
        }
        return factors;
    }
};

/// The best approximation of max(w . normal, 0) by harmonics up to `Order`: least squares over the directions
/// w with w . surface_normal >= 0, uniformly weighted. This holds what depends on the angle between the two
/// normals alone; `of` is asked with the normals themselves.
///
/// Irradiance is the integral of radiance times the clamped cosine, and no radiance comes from below the
/// surface. So this polynomial's integral with the radiance, which the summed moments contain, is the
/// irradiance of the radiance's own least squares fit over that hemisphere.
///
/// Derivation. With z along the surface's normal N, x along t = normal - c N and beta the angle between the
/// normals, max(w . normal, 0) = w . normal + r(w). The first term is a harmonic. The rest r is 0 unless
/// w . normal < 0; its integrals over the hemisphere are elementary, with e = 1 - c, c = cos beta and
/// s = sin beta:
///
///     r: pi e / 2        r z: 2 (s - beta c) / 3      r (3 z^2 - 1) / 2: pi e (3 e - 4) / 16
///     r x: -2 beta s / 3      r x z: -pi s e / 8      r (x^2 - y^2): pi s^2 / 8
///
/// The factors below are the inverses of the hemisphere's Gram matrices of {1, z}, {x} for order 1, and of
/// {1, z, (3 z^2 - 1) / 2}, {x, x z}, {x^2 - y^2} for order 2, applied to these. All of them are 0 for the
/// surface's own normal, whose irradiance is therefore exact for every light.
template <int Order>
requires(Order == 1 || Order == 2) class FittedClampedCosine {
  public:
    /// `cosine` and `sine` are those of the angle between the normals, from 0 to pi.
    FittedClampedCosine(float cosine, float sine) : cosine_(cosine) {
        constexpr float pi = std::numbers::pi_v<float>;
        const float s_sq = sine * sine;
        const float beta = std::atan2(sine, cosine);
        const float e = cosine > 0 ? s_sq / (1 + cosine) : 1 - cosine;  // 1 - c without its cancellation
        const float g = 2 / (3 * pi) * (sine - beta * cosine);          // the integral of r z, divided by pi
        if constexpr (Order == 1) {
            constant_ = e - 3 * g;
            by_surface_ = 6 * g - 1.5f * e;
            by_tilt_ = -beta / pi;
        } else {
            constant_ = (4.75f + 5.625f * e) * e - 48 * g;
            by_surface_ = 96 * g - (9 + 11.25f * e) * e;
            by_tilt_ = (22.5f * e - 64 / pi * beta) / 19;
            const float along = (5 + 7.5f * e) * e - 60 * g;       // of (3 z^2 - 1) / 2
            const float across = (120 / pi * beta - 60 * e) / 19;  // of x z, divided by s
            constexpr float around = 15.0f / 64;                   // of x^2 - y^2, divided by s^2
            surface_surface_ = 1.5f * along + around * s_sq;
            surface_tilt_ = across / 2;
            tilt_tilt_ = 2 * around;
            diagonal_ = along / 2 + around * s_sq;
        }
    }

    /// Returns the polynomial. Both normals are unit, and at that angle.
    [[nodiscard]] DirectionPolynomial of(const common::Vec3& surface_normal,
                                         const common::Vec3& normal) const {
        const common::Vec3 &n = surface_normal, t = normal - n * cosine_;
        DirectionPolynomial fit;
        fit.constant = constant_;
        fit.linear = normal + n * by_surface_ + t * by_tilt_;
        if constexpr (Order == 2) {
            // S = nn N N^T + nt (N t^T + t N^T) + tt t t^T - diagonal I, as y y^T = I - N N^T - x x^T.
            const auto entry = [&](int i, int j) {
                return surface_surface_ * n[i] * n[j] + surface_tilt_ * (n[i] * t[j] + t[i] * n[j]) +
                       tilt_tilt_ * t[i] * t[j];
            };
            fit.xx = entry(0, 0) - diagonal_;
            fit.yy = entry(1, 1) - diagonal_;
            fit.zz = entry(2, 2) - diagonal_;
            fit.xy = entry(0, 1);
            fit.yz = entry(1, 2);
            fit.xz = entry(0, 2);
        }
        return fit;
    }

  private:
    float cosine_, constant_, by_surface_, by_tilt_;
    float surface_surface_ = 0, surface_tilt_ = 0, tilt_tilt_ = 0, diagonal_ = 0;
};

/// Returns that approximation for two unit normals.
template <int Order>
[[nodiscard]] DirectionPolynomial fitted_clamped_cosine(const common::Vec3& surface_normal,
                                                        const common::Vec3& normal) {
    const float cosine = surface_normal.dot(normal);
    const float sine = (normal - surface_normal * cosine).length();
    return FittedClampedCosine<Order>(cosine, sine).of(surface_normal, normal);
}

}  // namespace shlm
