// The photon map: photons on surfaces, irradiance from the density of the nearest ones (Jensen 2001).
#pragma once

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/point_index/point_index.h"
#include "photonmap/gather_settings.h"
#include "photonmap/index/nearest_selection.h"
#include "photonmap/kernel.h"
#include "photonmap/photon_storage.h"
#include "photonmap/uncovered.h"

namespace photonmap {

/// The data that a gather needs of the photons that an index finds.
template <class P>
concept PhotonStore = requires(const P& photons, const common::Scene& scene, std::uint32_t index,
                               const common::Vec3& normal) {
    { photons.same_surface(scene, normal)(index) } -> std::same_as<bool>;
    { photons.tilted_flux(scene, index, normal) } -> std::same_as<common::Rgb>;
    { photons.size() } -> std::same_as<std::size_t>;
    { photons.bytes() } -> std::same_as<std::size_t>;
};

/// Photons and the index over their positions.
template <common::PointIndex Index, PhotonStore Photons>
struct IndexedPhotons {
    Photons photons;
    Index index;

    /// Returns the position of a photon, which either the photons or the index store.
    [[nodiscard]] common::Vec3 position(std::uint32_t i) const {
        if constexpr (requires { photons.positions(); })
            return photons.positions()[i];
        else
            return index.position(i);
    }
};

/// A finished, immutable photon map.
template <common::PointIndex Index, PhotonStore Photons = PhotonStorage>
class PhotonMap {
  public:
    using Stored = IndexedPhotons<Index, Photons>;

    /// `scene` and `covers`, if it is not null, must outlive the map. `watts_per_flux` as in common::MapSink.
    PhotonMap(const common::Scene& scene, Stored photons, float watts_per_flux, GatherSettings settings,
              const common::CoveringSurfaces* covers = nullptr)
        : PhotonMap(scene, std::make_shared<const Stored>(std::move(photons)), watts_per_flux, settings,
                    covers) {}

    /// Returns a map of the same photons with other gather settings.
    [[nodiscard]] PhotonMap with_gather(const GatherSettings& settings) const {
        return PhotonMap(*scene_, stored_, watts_per_flux_, settings, covers_);
    }

    /// Returns the irradiance for the shading normal, W/m^2.
    ///
    /// Photons count if they are within the largest radius and their surface faces as the point's does,
    /// except those on or over a surface that covers the point (Uncovered). If k are asked for and found, the
    /// k-th nearest gives the radius and does not count itself, so that k - 1 are divided by the area. With k
    /// in the numerator, the estimate of uniform light would be k / (k - 1) of the truth. Otherwise the
    /// radius is the largest and all of them count.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        return with_kernel(kernel_, [&](auto kernel) {
            return nearest_ > 0 ? from_nearest(point, kernel) : from_all_within(point, kernel);
        });
    }

    [[nodiscard]] std::size_t bytes() const {
        return stored_->photons.bytes() + stored_->index.bytes() + (covers_ ? covers_->bytes() : 0);
    }

    [[nodiscard]] std::size_t size() const { return stored_->photons.size(); }

    /// Returns the number of photons per gather; 0: all within the radius.
    [[nodiscard]] std::size_t nearest() const { return nearest_; }

  private:
    PhotonMap(const common::Scene& scene, std::shared_ptr<const Stored> stored, float watts_per_flux,
              const GatherSettings& settings, const common::CoveringSurfaces* covers)
        : scene_(&scene),
          covers_(covers),
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

    /// Returns a predicate that tells whether a photon counts. `point` must outlive it.
    [[nodiscard]] auto counted_at(const common::SurfacePoint& point) const {
        return [stored = stored_.get(),
                same_surface = stored_->photons.same_surface(*scene_, point.geometric_normal),
                uncovered = Uncovered(covers_, point)](std::uint32_t i) mutable {
            return same_surface(i) && uncovered(stored->position(i));
        };
    }

    template <class KernelFunction>
    [[nodiscard]] common::Rgb from_nearest(const common::SurfacePoint& point,
                                           const KernelFunction& kernel) const {
        // Reused by each thread: a gather must not allocate.
        static thread_local std::vector<NearestSelection::Key> room;
        room.resize(NearestSelection::room_for(nearest_));
        float radius_sq = max_radius_ * max_radius_;
        NearestSelection nearest(room, nearest_, radius_sq);
        stored_->index.search(point.position, nearest, counted_at(point));

        std::span<const NearestSelection::Key> counted = nearest.finish();
        if (counted.size() == nearest_) {
            // Photons that all lie in one point would give a radius of 0.
            radius_sq = std::max(NearestSelection::distance_sq(counted.front()), radius_sq * 1e-8f);
            counted = counted.subspan(1);
        }
        FluxSum sum(0, 0, 0);
        while (!counted.empty()) {
            const auto some = counted.first(std::min(counted.size(), summed_in_float));
            common::Rgb part(0, 0, 0);
            for (const NearestSelection::Key found : some)
                part += tilted_flux(NearestSelection::index(found), point) *
                        kernel(NearestSelection::distance_sq(found) / radius_sq);
            sum += FluxSum(part);
            counted = counted.subspan(some.size());
        }
        return over_disc(sum, radius_sq);
    }

    template <class KernelFunction>
    [[nodiscard]] common::Rgb from_all_within(const common::SurfacePoint& point,
                                              const KernelFunction& kernel) const {
        const float radius_sq = max_radius_ * max_radius_;
        FluxSum sum(0, 0, 0);
        common::AllWithin collector(radius_sq, [&](float distance_sq, std::uint32_t i) {
            sum += FluxSum(tilted_flux(i, point) * kernel(distance_sq / radius_sq));
        });
        stored_->index.search(point.position, collector, counted_at(point));
        return over_disc(sum, radius_sq);
    }

    /// The sum of the photons' flux in one gather. In double, as equal floats always round the same way: the
    /// sum of a million could be off by 1 %.
    using FluxSum = Imath::Color3<double>;
    /// So few floats have an error of at most 2^-19, and their sum is faster.
    static constexpr std::size_t summed_in_float = 64;

    [[nodiscard]] common::Rgb over_disc(const FluxSum& sum, float radius_sq) const {
        return common::Rgb(sum * (double{watts_per_flux_} / (std::numbers::pi * double{radius_sq})));
    }

    [[nodiscard]] common::Rgb tilted_flux(std::uint32_t photon, const common::SurfacePoint& point) const {
        return stored_->photons.tilted_flux(*scene_, photon, point.shading_normal);
    }

    const common::Scene* scene_;
    const common::CoveringSurfaces* covers_;  ///< null: all photons are uncovered
    std::shared_ptr<const Stored> stored_;
    float watts_per_flux_;
    Kernel kernel_;
    std::size_t nearest_;
    float max_radius_;  ///< world units
};

}  // namespace photonmap
