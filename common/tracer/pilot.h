// A pilot: a few photons sent ahead, to find out where the photons of each light go.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace common {

class PhotonSource;
class RayScene;

/// A photon that has hit this many surfaces is given up, so that paths in a room of perfect mirrors end.
inline constexpr std::uint32_t max_events = 4096;

/// The same limit for a scene that keeps nearly all light for so long. What is stored there depends on the
/// limit, whatever it is, and a lower one takes less time.
inline constexpr std::uint32_t max_events_of_endless_light = 64;

/// What happens to the photons of a light, or of all emitting surfaces of one material, until they hit a
/// diffuse surface.
struct LightReach {
    std::string light;    ///< as used in warnings
    double missed = 0;    ///< fraction of its light that hits no diffuse surface
    double on_backs = 0;  ///< fraction of the other light that hits the back of a single-sided surface
};

struct Pilot {
    std::vector<LightReach> light;
    std::vector<std::uint32_t> light_of_emitter;  ///< index into `light` for each of the source's emitters
    double endless = 0;  ///< fraction of all photons that are still alive after max_events surfaces
};

/// Sends a pilot. The result depends only on the scene, not on the seed of the run. Takes some milliseconds.
[[nodiscard]] Pilot send_pilot(const RayScene& rays, const PhotonSource& source);

}  // namespace common
