// Synthetic light on a surface that faces along +z.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace bench::bases {

/// Light from one direction, as much as one photon brings.
struct Arrival {
    common::Vec3 towards_light;  ///< unit, z > 0
    double irradiance;           ///< on the surface, W/m^2, mean of the channels: includes the cosine
    common::Rgb tint{1, 1, 1};   ///< each channel's share, of mean 1
};

using Environment = std::vector<Arrival>;

enum class LightKind {
    point,          ///< one distant light
    room,           ///< six lobes over a dim floor: lamps, windows, lit walls
    uniform,        ///< constant radiance
    coloured_room,  ///< as room, each lobe in a colour of its own
};

inline constexpr std::array light_kinds = {LightKind::point, LightKind::room, LightKind::coloured_room,
                                           LightKind::uniform};

[[nodiscard]] std::string name_of(LightKind kind);

/// In words, for the table.
[[nodiscard]] std::string description_of(LightKind kind);

/// How many environments there are to look at where `wanted` random ones are asked for: one if none differ.
[[nodiscard]] std::size_t environment_count(LightKind kind, std::size_t wanted);

/// Environment `index` of `count`; the same for the same arguments.
///
/// The point lights are uniform in solid angle more than 10 degrees above the horizon; the i-th is in the
/// i-th of `count` equal belts of it, from the horizon up, so that the set has the whole range whatever the
/// seed. Rooms are independent of each other.
[[nodiscard]] Environment make_environment(LightKind kind, std::uint32_t index, std::size_t count,
                                           std::uint64_t seed);

}  // namespace bench::bases
