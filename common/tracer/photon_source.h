// All light of a scene as one source of photons.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "common/core/sampling.h"
#include "common/scene/scene.h"
#include "common/tracer/photon_batch.h"

namespace common {

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
    bool textured;
    float area;
    Rgb mean_radiance;  ///< over the triangle; chooses the emitter, and is what it emits if not textured
    Vec3 corner, edge_u, edge_v;
    Frame frame;  ///< around the front normal
};

struct PointEmitter {
    PointLight light;
};

struct SpotEmitter {
    SpotLight light;
};

/// Parallel light through the disc that the scene's bounding sphere shows it.
struct DirectionalEmitter {
    DirectionalLight light;
    Vec3 center;
    float radius;
};

/// Uniform light through the scene's bounding sphere.
struct SkyEmitter {
    Sky sky;
    Vec3 center;
    float radius;
};

using Emitter = std::variant<AreaEmitter, PointEmitter, SpotEmitter, DirectionalEmitter, SkyEmitter>;

/// The random numbers of one emission.
struct EmissionNumbers {
    std::array<float, 4> at, towards;  ///< uniform
    Vec3 lobe;                         ///< cosine-distributed around +z, made of `towards`
};

class PhotonSource {
  public:
    /// Throws InputError where the scene has no light. `scene` must outlive this object.
    explicit PhotonSource(const Scene& scene);

    /// Photon number `index` of the run with this seed. Lights are chosen in proportion to their power.
    [[nodiscard]] EmittedPhoton emit(std::uint64_t seed, std::uint64_t index) const;

    /// Photons `first_photon`, ... of the run, as `emit` makes them, moved off their lights by
    /// `surface_offset`; as many as `photons` has room for.
    void emit(std::uint64_t seed, std::uint64_t first_photon, float surface_offset,
              PhotonBatch& photons) const;

    /// Sum over all lights, W.
    [[nodiscard]] const Rgb& power() const { return power_; }

  private:
    void add(const Emitter& emitter);
    [[nodiscard]] EmittedPhoton emit(const EmissionNumbers& numbers) const;

    const Scene* scene_;
    std::vector<Emitter> emitters_;
    std::vector<float> inverse_probability_;  ///< of choosing each emitter
    std::vector<double>
        cumulative_;  ///< sum of powers up to and with each emitter, mean over the channels, W
    Rgb power_{0, 0, 0};
};

}  // namespace common
