#include "bench/experiments/bases/environment.h"

#include <numbers>

#include "bench/experiments/bases/directions.h"
#include "common/estimator/irradiance_estimator.h"
#include "common/reference/random_stream.h"

namespace bench::bases {
namespace {

using common::Vec3;
using common::reference::RandomStream;

/// Number of directions that approximate soft light: they are 3 degrees apart, and its lobes are at least 20
/// degrees wide.
constexpr std::size_t soft_directions = 2048;

/// Light below the accumulator's clamp of the cosine is left out, since the clamp's error is not the basis's.
constexpr double least_soft_cosine = common::min_incident_cosine;

const double least_point_cosine = std::sin(10 * std::numbers::pi / 180);
constexpr int lobes = 6;
constexpr double floor_radiance = 0.1;  // W/(m^2 sr)

Vec3 direction(double z, double turn) {
    const double r = std::sqrt(1 - z * z), azimuth = 2 * std::numbers::pi * turn;
    return Vec3(Imath::V3d(r * std::cos(azimuth), r * std::sin(azimuth), z));
}

Environment point_light(RandomStream& random, std::uint32_t index, std::size_t count) {
    const double share = (index + random.next()) / static_cast<double>(count);
    const Vec3 towards_light =
        direction(least_point_cosine + (1 - least_point_cosine) * share, random.next());
    return {{towards_light, towards_light.z}};
}

/// Samples `radiance(direction)`, W/(m^2 sr), over the hemisphere.
template <class Radiance>
Environment soft_light(Radiance radiance) {
    const double solid_angle = cap_solid_angle(least_soft_cosine) / static_cast<double>(soft_directions);
    Environment environment;
    environment.reserve(soft_directions);
    for (const Vec3& towards_light : directions_in_cap(soft_directions, least_soft_cosine))
        environment.push_back({towards_light, radiance(towards_light) * towards_light.z * solid_angle});
    return environment;
}

struct Lobe {
    Vec3 axis;        ///< unit
    double radiance;  ///< along the axis, W/(m^2 sr)
    double exponent;  ///< of the cosine to the axis
    common::Rgb tint{1, 1, 1};
};

Lobe random_lobe(RandomStream& random) {
    const double z = random.next(), turn = random.next();
    const double radiance = random.next();
    return {direction(z, turn), radiance, 2 * std::pow(16.0, random.next())};
}

double radiance_of(const Lobe& lobe, const Vec3& towards_light) {
    return lobe.radiance *
           std::pow(std::max(0.0, static_cast<double>(towards_light.dot(lobe.axis))), lobe.exponent);
}

/// Returns a colour from grey to nearly a single channel, of mean 1.
common::Rgb random_tint(RandomStream& random) {
    const double r = random.next(), g = random.next(), b = random.next();
    return common::Rgb(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)) *
           static_cast<float>(3 / (r + g + b));
}

Environment room(RandomStream& random, bool coloured) {
    std::array<Lobe, lobes> parts;
    for (Lobe& lobe : parts) lobe = random_lobe(random);
    if (coloured)
        for (Lobe& lobe : parts) lobe.tint = random_tint(random);
    const auto all_radiance = [&](const Vec3& towards_light) {
        double radiance = floor_radiance;
        for (const Lobe& lobe : parts) radiance += radiance_of(lobe, towards_light);
        return radiance;
    };
    Environment environment = soft_light(all_radiance);
    for (Arrival& arrival : environment) {
        common::Rgb light = common::Rgb(1, 1, 1) * static_cast<float>(floor_radiance);
        for (const Lobe& lobe : parts)
            light += lobe.tint * static_cast<float>(radiance_of(lobe, arrival.towards_light));
        arrival.tint = light / common::mean_component(light);
    }
    return environment;
}

}  // namespace

std::string name_of(LightKind kind) {
    switch (kind) {
        case LightKind::point:
            return "point light";
        case LightKind::room:
            return "mixed room";
        case LightKind::uniform:
            return "uniform hemisphere";
        case LightKind::coloured_room:
            return "coloured room";
    }
    return "";
}

std::string description_of(LightKind kind) {
    switch (kind) {
        case LightKind::point:
            return "one directional light, uniform in solid angle over the directions more than 10 degrees "
                   "above "
                   "the horizon, one in each of as many equal belts as there are environments";
        case LightKind::room:
            return "constant radiance 0.1 plus six lobes a max(0, w.d)^s: d uniform in solid angle over the "
                   "upper "
                   "hemisphere, a uniform from 0 to 1, s log-uniform from 2 to 32";
        case LightKind::uniform:
            return "constant radiance";
        case LightKind::coloured_room:
            return "as mixed room; each lobe has a colour, three channels uniform from 0 to 1, divided by "
                   "their mean";
    }
    return "";
}

std::size_t environment_count(LightKind kind, std::size_t wanted) {
    return kind == LightKind::uniform ? 1 : wanted;
}

Environment make_environment(LightKind kind, std::uint32_t index, std::size_t count, std::uint64_t seed) {
    RandomStream random(seed, index, static_cast<std::uint32_t>(kind), 0);
    switch (kind) {
        case LightKind::point:
            return point_light(random, index, count);
        case LightKind::room:
            return room(random, false);
        case LightKind::coloured_room:
            return room(random, true);
        case LightKind::uniform:
            return soft_light([](const Vec3&) { return 1.0; });
    }
    return {};
}

}  // namespace bench::bases
