// The photon map: photons on surfaces, irradiance from the density of the nearest ones (Jensen 2001).
#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/point_index/point_index.h"
#include "photonmap/gather_settings.h"
#include "photonmap/kernel.h"
#include "photonmap/photon_storage.h"

namespace photonmap {

/// Finished, immutable. `Index` finds the nearest photons; it has been built over the storage's positions.
template <common::PointIndex Index>
class PhotonMap {
  public:
    /// `scene` must outlive the map. `watts_per_flux` as in common::MapSink.
    PhotonMap(const common::Scene& scene, PhotonStorage photons, Index index, float watts_per_flux,
              GatherSettings settings)
        : scene_(&scene),
          photons_(std::move(photons)),
          index_(std::move(index)),
          watts_per_flux_(watts_per_flux),
          settings_(settings) {}

    /// Irradiance for the shading normal, W/m^2.
    ///
    /// The photons that count are those within max_radius whose surface faces as the point's does. With k of
    /// them or more, the k-th nearest gives the radius and does not count itself, so that k - 1 are divided
    /// by the area: with k in the numerator the estimate of uniform light would be k / (k - 1) of the truth.
    /// With fewer than k the radius is max_radius and all of them count.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        // Reused by each thread: a gather must not allocate.
        static thread_local std::vector<common::Neighbour> neighbours;
        neighbours.resize(settings_.nearest);
        common::NearestSet nearest(neighbours, settings_.max_radius * settings_.max_radius);
        index_.search(point.position, nearest, [&](std::uint32_t i) {
            return arrival_normal(photons_[i], scene_->geometric_normal).dot(point.geometric_normal) >
                   common::same_surface_cosine;
        });
        if (settings_.cone_slope > 0) return density(nearest, point, ConeKernel(settings_.cone_slope));
        return density(nearest, point, DiscKernel{});
    }

    [[nodiscard]] std::size_t bytes() const { return photons_.bytes() + index_.bytes(); }

    [[nodiscard]] std::size_t size() const { return photons_.size(); }

  private:
    template <class Kernel>
    [[nodiscard]] common::Rgb density(const common::NearestSet& nearest, const common::SurfacePoint& point,
                                      const Kernel& kernel) const {
        std::span<const common::Neighbour> counted = nearest.found();
        float radius_sq = settings_.max_radius * settings_.max_radius;
        if (nearest.full()) {
            // Photons that all lie in one point have no radius of their own.
            radius_sq = std::max(counted.front().distance_sq, radius_sq * 1e-8f);
            counted = counted.subspan(1);
        }
        common::Rgb sum(0, 0, 0);
        for (const common::Neighbour& neighbour : counted) {
            const Photon& photon = photons_[neighbour.index];
            sum += photon.flux * (kernel(neighbour.distance_sq / radius_sq) * tilt(photon, point));
        }
        return sum * (watts_per_flux_ / (std::numbers::pi_v<float> * radius_sq));
    }

    /// What a unit of irradiance on the photon's own surface becomes on a plane with the shading normal: the
    /// ratio of the two cosines of incidence.
    [[nodiscard]] float tilt(const Photon& photon, const common::SurfacePoint& point) const {
        const float on_surface = std::abs(photon.direction.dot(scene_->geometric_normal[photon.triangle]));
        const float on_shading = std::max(0.0f, -photon.direction.dot(point.shading_normal));
        return on_shading / std::max(on_surface, common::min_incident_cosine);
    }

    const common::Scene* scene_;
    PhotonStorage photons_;
    Index index_;
    float watts_per_flux_;
    GatherSettings settings_;
};

}  // namespace photonmap
