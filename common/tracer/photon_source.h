// All light of a scene as one source of photons.
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

/// Nothing in the scene shines; who calls may say how to add a light.
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
    std::optional<std::uint32_t> triangle = {};  ///< that it leaves, where the light has a surface
};

/// A triangle that emits with a cosine lobe, from its front or from both faces.
struct AreaEmitter {
    std::uint32_t triangle;
    bool both_faces;
    std::shared_ptr<const EmissionCells> cells;  ///< of an emissive texture; none without
    bool varies;                                 ///< from place to place: texture, or holes
    float area;
    Rgb mean_radiance;  ///< over the triangle, holes included; chooses the emitter, and is what it emits if
                        ///< that does not vary
    Vec3 corner, edge_u, edge_v;
    Frame frame;  ///< around the front normal
};

/// Directions around a unit vector.
struct Cone {
    Vec3 axis;
    float versine;  ///< 1 - cosine of half its angle
};

/// Emits all around, or from afar only towards the scene.
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

/// Of photon number `index` of the run with this seed.
[[nodiscard]] EmissionNumbers emission_numbers(std::uint64_t seed, std::uint64_t index);

class PhotonSource {
  public:
    /// Throws InputError where the scene has no light. `scene` must outlive this object.
    explicit PhotonSource(const Scene& scene);

    /// Sends a pilot first. A light that loses more than half of what it emits gets photons in proportion to
    /// what it does not lose, at least to a hundredth, and where light does not end, photons are given up
    /// earlier. All other scenes have the photons that they have without.
    explicit PhotonSource(const RayScene& rays);

    /// Photon number `index` of the run with this seed. Lights are chosen in proportion to their power.
    [[nodiscard]] EmittedPhoton emit(std::uint64_t seed, std::uint64_t index) const;

    /// Photons `first_photon`, ... of the run, as `emit` makes them, moved off their lights by
    /// `surface_offset`; as many as `photons` has room for.
    void emit(std::uint64_t seed, std::uint64_t first_photon, float surface_offset,
              PhotonBatch& photons) const;

    /// Sum over all lights, W: of those outside, what enters the scene's bounds.
    [[nodiscard]] const Rgb& power() const { return power_; }

    [[nodiscard]] std::span<const Emitter> emitters() const { return emitters_; }

    /// Of one emitter, W, mean over the channels.
    [[nodiscard]] double mean_power(std::size_t emitter) const;

    /// A photon with all power of one emitter. Of `numbers`, the first and the last for its origin are not
    /// used; `within` is uniform in [0, 1).
    [[nodiscard]] EmittedPhoton emit_from(std::size_t emitter, const EmissionNumbers& numbers,
                                          double within = 0.5) const;

    /// What the pilot has found; nothing of any light where none was sent.
    [[nodiscard]] const Pilot& pilot() const { return pilot_; }

    /// Surfaces that a photon may meet before it is given up.
    [[nodiscard]] std::uint32_t most_events() const { return most_events_; }

  private:
    void add(const Emitter& emitter);
    void weigh_by_pilot();
    [[nodiscard]] EmittedPhoton emit(const EmissionNumbers& numbers) const;

    const Scene* scene_;
    std::vector<Emitter> emitters_;
    std::vector<float> inverse_probability_;  ///< of choosing each emitter
    std::vector<double> cumulative_;          ///< sum up to and with each emitter of its power, mean over the
                                              ///< channels, W, times what the pilot says
    Rgb power_{0, 0, 0};
    Pilot pilot_;
    std::uint32_t most_events_ = max_events;
};

}  // namespace common
