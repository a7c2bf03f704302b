// Synthetic light on a surface that faces +z.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace bench::bases {

/// Light from one direction, which one photon represents.
struct Arrival {
    common::Vec3 towards_light;  ///< unit, z > 0
    double irradiance;           ///< on the surface, W/m^2, mean of the channels, with the cosine
    common::Rgb tint{1, 1, 1};   ///< factor of each channel, mean 1
};

using Environment = std::vector<Arrival>;

enum class LightKind {
    point,          ///< one distant light
    room,           ///< six lobes over a dim floor: lamps, windows, lit walls
    uniform,        ///< constant radiance
    coloured_room,  ///< like room, with a different colour for each lobe
};

inline constexpr std::array light_kinds = {LightKind::point, LightKind::room, LightKind::coloured_room,
                                           LightKind::uniform};

[[nodiscard]] std::string name_of(LightKind kind);

/// Describes the kind in words, for the table.
[[nodiscard]] std::string description_of(LightKind kind);

/// Returns the number of environments for `wanted` random ones: one if all are equal.
[[nodiscard]] std::size_t environment_count(LightKind kind, std::size_t wanted);

/// Makes environment `index` of `count`, which depends only on the arguments.
///
/// Point lights are uniform in solid angle above 10 degrees over the horizon. The i-th is in the i-th of
/// `count` belts of equal solid angle, from the horizon up, so that the set covers the whole range for every
/// seed. Rooms are independent of each other.
[[nodiscard]] Environment make_environment(LightKind kind, std::uint32_t index, std::size_t count,
                                           std::uint64_t seed);

}  // namespace bench::bases
