// Packed photons, during tracing and in a map.
#pragma once

#include <span>

#include "common/core/stable_array.h"
#include "common/estimator/irradiance_estimator.h"
#include "common/scene/scene.h"
#include "common/tracer/hit_batch.h"
#include "photonmap/index/compact_index.h"
#include "photonmap/packed_photon.h"

namespace photonmap {

/// The photons' data for gathers, except for positions, which CompactIndex has; 10 bytes per place.
class PackedPhotons {
  public:
    PackedPhotons() = default;

    /// Returns a predicate that tells whether a photon's surface faces as `normal` does.
    [[nodiscard]] auto same_surface(const common::Scene& /*scene*/, const common::Vec3& normal) const {
        // Neighbours mostly lie on one plane, so the answer for the last normal is kept.
        return [normals = normals_.span().data(), normal, known = std::uint32_t{0x10000},
                answer = false](std::uint32_t i) mutable {
            if (normals[i] != known) {
                known = normals[i];
                answer = PackedNormal::unpack(known).dot(normal) > common::same_surface_cosine;
            }
            return answer;
        };
    }

    /// Returns a photon's flux for the shading normal, W times the number emitted.
    [[nodiscard]] common::Rgb tilted_flux(const common::Scene& /*scene*/, std::uint32_t i,
                                          const common::Vec3& shading_normal) const {
        return lights_[i].facing_flux() * std::max(0.0f, -lights_[i].direction().dot(shading_normal));
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t bytes() const { return normals_.bytes() + lights_.bytes(); }

  private:
    friend class PackedPhotonStorage;

    static constexpr std::size_t most_places = std::size_t{1} << 32;
    common::StableArray<std::uint16_t> normals_{most_places};
    common::StableArray<PackedLight> lights_{most_places};
    std::size_t size_ = 0;
};

/// Stores hits: append-only.
class PackedPhotonStorage {
  public:
    /// `scene` must outlive this object.
    explicit PackedPhotonStorage(const common::Scene& scene) : scene_(&scene) {}

    /// Appends the finite hits of a wave in order, with all threads of the calling arena. Throws InputError
    /// past CompactIndex::max_points.
    void append(std::span<const common::HitBatch> wave);

    struct Indexed {
        PackedPhotons photons;
        CompactIndex index;
    };
    /// Returns the photons in the order of the index, and the index.
    [[nodiscard]] Indexed indexed() &&;

    [[nodiscard]] std::size_t size() const { return photons_.size(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes(); }
    [[nodiscard]] const common::RejectedHits& rejected() const { return rejected_; }

  private:
    const common::Scene* scene_;
    common::StableArray<PackedPhoton> photons_{CompactIndex::max_points};
    common::RejectedHits rejected_;
};

}  // namespace photonmap
