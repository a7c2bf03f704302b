// The photon map: photons on surfaces, irradiance from the density of the nearest ones (Jensen 2001).
#pragma once

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/point_index/point_index.h"
#include "photonmap/gather_settings.h"
#include "photonmap/kernel.h"
#include "photonmap/photon_storage.h"

namespace photonmap {

/// Photons and the index over their positions.
template <common::PointIndex Index>
struct IndexedPhotons {
    PhotonStorage photons;
    Index index;
};

/// Finished, immutable.
template <common::PointIndex Index>
class PhotonMap {
  public:
    /// `scene` must outlive the map. `watts_per_flux` as in common::MapSink.
    PhotonMap(const common::Scene& scene, IndexedPhotons<Index> photons, float watts_per_flux,
              GatherSettings settings)
        : PhotonMap(scene, std::make_shared<const IndexedPhotons<Index>>(std::move(photons)), watts_per_flux,
                    settings) {}

    /// The same photons asked in another way.
    [[nodiscard]] PhotonMap with_gather(const GatherSettings& settings) const {
        return PhotonMap(*scene_, stored_, watts_per_flux_, settings);
    }

    /// Irradiance for the shading normal, W/m^2.
    ///
    /// The photons that count are those within the largest radius whose surface faces as the point's does.
    /// Where k are asked for and found, the k-th nearest gives the radius and does not count itself, so that
    /// k - 1 are divided by the area: with k in the numerator the estimate of uniform light would be
    /// k / (k - 1) of the truth. Otherwise the radius is the largest and all of them count.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        return with_kernel(kernel_, [&](auto kernel) {
            return nearest_ > 0 ? from_nearest(point, kernel) : from_all_within(point, kernel);
        });
    }

    [[nodiscard]] std::size_t bytes() const { return stored_->photons.bytes() + stored_->index.bytes(); }

    [[nodiscard]] std::size_t size() const { return stored_->photons.size(); }

    /// Photons per gather; 0: all within the radius.
    [[nodiscard]] std::size_t nearest() const { return nearest_; }

  private:
    PhotonMap(const common::Scene& scene, std::shared_ptr<const IndexedPhotons<Index>> stored,
              float watts_per_flux, const GatherSettings& settings)
        : scene_(&scene),
          stored_(std::move(stored)),
          watts_per_flux_(watts_per_flux),
          kernel_(settings.kernel),
          nearest_(number_of_nearest(settings.selection, stored_->photons.size())),
          max_radius_(largest_radius(settings, scene.diagonal())) {}

    static std::size_t number_of_nearest(const PhotonSelection& selection, std::size_t photons) {
        if (const auto* nearest = std::get_if<NearestPhotons>(&selection)) return nearest->count;
        if (const auto* growing = std::get_if<GrowingNumber>(&selection))
            return std::max<std::size_t>(
                2, std::llround(growing->factor * std::pow(static_cast<double>(photons), 2.0 / 3)));
        return 0;
    }

    [[nodiscard]] bool is_on_same_surface(std::uint32_t photon, const common::SurfacePoint& point) const {
        return arrival_normal(stored_->photons[photon], scene_->geometric_normal)
                   .dot(point.geometric_normal) > common::same_surface_cosine;
    }

    template <class KernelFunction>
    [[nodiscard]] common::Rgb from_nearest(const common::SurfacePoint& point,
                                           const KernelFunction& kernel) const {
        // Reused by each thread: a gather must not allocate.
        static thread_local std::vector<common::Neighbour> neighbours;
        neighbours.resize(nearest_);
        common::NearestSet nearest(neighbours, max_radius_ * max_radius_);
        stored_->index.search(point.position, nearest,
                              [&](std::uint32_t i) { return is_on_same_surface(i, point); });

        std::span<const common::Neighbour> counted = nearest.found();
        float radius_sq = max_radius_ * max_radius_;
        if (nearest.full()) {
            // Photons that all lie in one point have no radius of their own.
            radius_sq = std::max(counted.front().distance_sq, radius_sq * 1e-8f);
            counted = counted.subspan(1);
        }
        common::Rgb sum(0, 0, 0);
        for (const common::Neighbour& neighbour : counted)
            sum += tilted_flux(neighbour.index, point) * kernel(neighbour.distance_sq / radius_sq);
        return sum * (watts_per_flux_ / (std::numbers::pi_v<float> * radius_sq));
    }

    template <class KernelFunction>
    [[nodiscard]] common::Rgb from_all_within(const common::SurfacePoint& point,
                                              const KernelFunction& kernel) const {
        const float radius_sq = max_radius_ * max_radius_;
        common::Rgb sum(0, 0, 0);
        common::AllWithin collector(radius_sq, [&](float distance_sq, std::uint32_t i) {
            sum += tilted_flux(i, point) * kernel(distance_sq / radius_sq);
        });
        stored_->index.search(point.position, collector,
                              [&](std::uint32_t i) { return is_on_same_surface(i, point); });
        return sum * (watts_per_flux_ / (std::numbers::pi_v<float> * radius_sq));
    }

    /// A photon's flux as the shading normal sees it: what a unit of irradiance on the photon's own surface
    /// becomes on a plane with that normal is the ratio of the two cosines of incidence.
    [[nodiscard]] common::Rgb tilted_flux(std::uint32_t index, const common::SurfacePoint& point) const {
        const Photon& photon = stored_->photons[index];
        const float on_surface = std::abs(photon.direction.dot(scene_->geometric_normal[photon.triangle]));
        const float on_shading = std::max(0.0f, -photon.direction.dot(point.shading_normal));
        return photon.flux * (on_shading / std::max(on_surface, common::min_incident_cosine));
    }

    const common::Scene* scene_;
    std::shared_ptr<const IndexedPhotons<Index>> stored_;
    float watts_per_flux_;
    Kernel kernel_;
    std::size_t nearest_;
    float max_radius_;  ///< world units
};

}  // namespace photonmap
