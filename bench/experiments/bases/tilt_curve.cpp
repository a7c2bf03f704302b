#include "bench/experiments/bases/tilt_curve.h"

#include <numbers>

#include "bench/experiments/bases/basis_error.h"

namespace bench::bases {
namespace {

constexpr double light_degrees = 40;
constexpr int most_tilt = 60;  // degrees

common::Vec3 direction_at_angle(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return common::Vec3(Imath::V3d(std::sin(angle), 0, std::cos(angle)));
}

}  // namespace

TiltCurve measure_tilt_curve() {
    TiltCurve curve{light_degrees, {}, {}, {}};
    std::vector<common::Vec3> normals;
    for (int tilt = -most_tilt; tilt <= most_tilt; ++tilt) {
        curve.degrees.push_back(tilt);
        normals.push_back(direction_at_angle(tilt));
    }
    const common::Vec3 towards_light = direction_at_angle(light_degrees);
    const Environment light = {{towards_light, towards_light.z}};
    const OneTexel texel;
    curve.truth = true_irradiance(light, normals);
    for (const Basis& basis : all_bases())
        curve.answers.push_back(basis.ask(texel, texel.photons_of(light), normals));
    return curve;
}

}  // namespace bench::bases
