// All lights of a scene as one source of photons.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "common/core/input_error.h"
#include "common/core/sampling.h"
#include "common/scene/scene.h"
#include "common/tracer/bounds_entry.h"
#include "common/tracer/emission_cells.h"
#include "common/tracer/photon_batch.h"
#include "common/tracer/pilot.h"

namespace common {

/// Thrown if nothing in the scene emits light. The caller may say how to add a light.
class NoLight : public InputError {
  public:
    using InputError::InputError;
};

/// A photon as it leaves its light.
struct EmittedPhoton {
    Vec3 origin;
    Vec3 direction;  ///< unit, the way it travels
    Vec3 normal;     ///< unit, of the emitting face; the direction itself for lights without a surface
    Rgb flux;        ///< W times the number of photons emitted in the whole run
    std::optional<std::uint32_t> triangle = {};  ///< the triangle that it leaves, if the light has a surface
};

/// A triangle that emits with a cosine lobe, from its front or from both faces.
struct AreaEmitter {
    std::uint32_t triangle;
    bool both_faces;
    std::shared_ptr<const EmissionCells> cells;  ///< for an emissive texture; null without one
    bool varies;                                 ///< over the triangle, because of a texture or holes
    float area;
    Rgb mean_radiance;  ///< mean over the triangle, holes included; weight for choosing the emitter, and its
                        ///< radiance if that does not vary
    Vec3 corner, edge_u, edge_v;
    Frame frame;  ///< around the front normal
};

/// Directions around a unit vector.
struct Cone {
    Vec3 axis;
    float versine;  ///< 1 - cosine of half its angle
};

/// Emits in all directions, or from far away only towards the scene.
struct PointEmitter {
    PointLight light;
    std::optional<Cone> towards_scene;
};

struct SpotEmitter {
    SpotLight light;
};

/// Parallel light through the scene's bounding box.
struct DirectionalEmitter {
    DirectionalLight light;
    BoundsEntry entry;
};

/// Uniform light through the scene's bounding box.
struct SkyEmitter {
    Sky sky;
    BoundsEntry entry;
};

using Emitter = std::variant<AreaEmitter, PointEmitter, SpotEmitter, DirectionalEmitter, SkyEmitter>;

/// The random numbers of one emission.
struct EmissionNumbers {
    std::array<float, 4> at, towards;  ///< uniform
    Vec3 lobe;                         ///< cosine-distributed around +z, made of `towards`
};

/// Returns those of photon number `index` of the run with this seed, all independent.
[[nodiscard]] EmissionNumbers emission_numbers(std::uint64_t seed, std::uint64_t index);

/// How the photons of a run are spread.
enum class EmissionSequence : std::uint8_t {
    random,  ///< independent of each other
    sobol  ///< point number `index` of a scrambled Sobol' sequence of direction, place, light and face. Each
           ///< seed, and each 2^32 photons of a run, have a scramble of their own. 2^m photons from a
           ///< multiple of 2^m on are spread best.
};

class PhotonSource {
  public:
    /// Throws NoLight, an InputError, if the scene has no light. `scene` must outlive this object.
    explicit PhotonSource(const Scene& scene);

    /// Sends a pilot first. A light that loses more than half of its photons gets a number in proportion to
    /// what it does not lose, but at least a hundredth of its share. If hardly any photon is absorbed or
    /// escapes, photons are given up earlier. All other scenes have the same photons as without a pilot.
    explicit PhotonSource(const RayScene& rays, EmissionSequence sequence = EmissionSequence::random);

    /// Returns photon number `index` of the run with this seed. Lights are chosen in proportion to their
    /// power.
    [[nodiscard]] EmittedPhoton emit(std::uint64_t seed, std::uint64_t index) const;

    /// Emits photons `first_photon`, ... of the run as above, offset from their lights by `surface_offset`;
    /// as many as `photons` has room for.
    void emit(std::uint64_t seed, std::uint64_t first_photon, float surface_offset,
              PhotonBatch& photons) const;

    /// Returns the power of all lights, W; of those outside, the power that enters the scene's bounds.
    [[nodiscard]] const Rgb& power() const { return power_; }

    [[nodiscard]] std::span<const Emitter> emitters() const { return emitters_; }

    /// Returns the power of one emitter, W, mean over the channels.
    [[nodiscard]] double mean_power(std::size_t emitter) const;

    /// Returns a photon with the whole power of one emitter. Does not use the first and the last of the
    /// `numbers` for its origin; `within` is uniform in [0, 1).
    [[nodiscard]] EmittedPhoton emit_from(std::size_t emitter, const EmissionNumbers& numbers,
                                          double within = 0.5) const;

    /// Returns the results of the pilot; empty if none was sent.
    [[nodiscard]] const Pilot& pilot() const { return pilot_; }

    /// Returns the number of surfaces that a photon may hit before it is given up.
    [[nodiscard]] std::uint32_t most_events() const { return most_events_; }

  private:
    void add(const Emitter& emitter);
    void weigh_by_pilot();
    [[nodiscard]] EmittedPhoton emit(const EmissionNumbers& numbers) const;

    const Scene* scene_;
    EmissionSequence sequence_ = EmissionSequence::random;
    std::vector<Emitter> emitters_;
    std::vector<float> inverse_probability_;  ///< of choosing each emitter
    std::vector<double> cumulative_;          ///< cumulative power up to and including each emitter, mean
                                              ///< over the channels, W, times the factor from the pilot
    Rgb power_{0, 0, 0};
    Pilot pilot_;
    std::uint32_t most_events_ = max_events;
};

}  // namespace common
