// A few photons sent ahead, to see what becomes of each light.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace common {

class PhotonSource;
class RayScene;

/// A photon that has met this many surfaces is given up, so that a room of perfect mirrors ends.
inline constexpr std::uint32_t max_events = 4096;

/// The same in a scene that keeps nearly all light for so long. What is stored there depends on where photons
/// are given up, at whichever number, and fewer take less time.
inline constexpr std::uint32_t max_events_of_endless_light = 64;

/// What becomes of the photons of a light, or of all surfaces of one material that emits, until they meet a
/// diffuse surface.
struct LightReach {
    std::string light;    ///< as warnings call it
    double missed = 0;    ///< share of its light that meets no diffuse surface
    double on_backs = 0;  ///< of what meets one, the share that meets the back of one that has but a front
};

struct Pilot {
    std::vector<LightReach> light;
    std::vector<std::uint32_t> light_of_emitter;  ///< index into `light` for each of the source's emitters
    double endless = 0;  ///< share of all photons that max_events surfaces do not end
};

/// The same for the same scene, whatever the seed of the run. Takes some milliseconds.
[[nodiscard]] Pilot send_pilot(const RayScene& rays, const PhotonSource& source);

}  // namespace common
